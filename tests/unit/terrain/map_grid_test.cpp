// Grids of maps, and the maps written on them.
#include "terrain/raster/map_grid.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "ground_fixture.h"
#include "terrain/raster/raster_export.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

std::string why_refused(const std::function<void()>& make) {
  try {
    make();
  } catch (const InputError& error) {
    return error.faults().front().what;
  }
  return "";
}

TEST(MapGrid, has_fewer_cells_where_more_is_held_of_each) {
  // The window is 30.3 km square.
  const MapWindow window{0, 0, 1, 1};
  const Body& moon = *find_body("Moon");
  const auto of_window = [&](int values) {
    return why_refused([&] { grid_of_window(moon, window, 2.5, values); });
  };
  EXPECT_EQ(of_window(1), "");
  EXPECT_THAT(of_window(2), HasSubstr("134217728 are allowed"));

  const std::string file = "/vsimem/wide.tif";
  GDALAllRegister();
  const char* const sparse[] = {"SPARSE_OK=TRUE", nullptr};
  GDALDatasetUniquePtr dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      file.c_str(), 12'000, 12'000, 1, GDT_Byte, const_cast<char**>(sparse)));
  double transform[] = {0, 1, 0, 0, 0, -1};
  dataset->SetGeoTransform(transform);
  OGRSpatialReference crs;
  crs.importFromProj4("+proj=eqc +R=1737400 +units=m");
  dataset->SetSpatialRef(&crs);
  dataset.reset();
  const Raster raster({file}, {}, nullptr);
  const auto of_raster = [&](int values) {
    return why_refused([&] { grid_of_raster(raster, {}, {{}, file}, values); });
  };
  EXPECT_EQ(of_raster(1), "");
  EXPECT_THAT(of_raster(2), HasSubstr("134217728 are allowed at once"));
}

// The map has waves 80 m high in cells of 30.48 m.
std::vector<std::uint8_t> hillshade(const char* unit, double unit_m) {
  OGRSpatialReference crs;
  crs.importFromProj4((std::string("+proj=eqc +R=1737400 +units=") + unit).c_str());
  char* wkt = nullptr;
  crs.exportToWkt(&wkt);
  constexpr int side = 40;
  const double cell = 30.48 / unit_m;
  MapGrid grid{wkt, {-side / 2 * cell, cell, 0, side / 2 * cell, 0, -cell}, side, side};
  CPLFree(wkt);
  const std::string file = ::testing::TempDir() + "lsos_hillshade_" + unit + ".tif";
  write_raster({file, true}, grid, *find_body("Moon"), [](const Geodetic& place) {
    return 20 * (std::sin(4e4 * place.lon_rad) + std::cos(3e4 * place.lat_rad));
  });
  GDALDatasetUniquePtr written(GDALDataset::Open(file.c_str()));
  std::vector<std::uint8_t> shade(side * side);
  EXPECT_EQ(written->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, side, side, shade.data(), side, side,
                                                GDT_Byte, 0, 0, nullptr),
            CE_None);
  return shade;
}

TEST(Hillshade, of_a_map_in_feet_is_that_of_one_in_metres) {
  const auto of_feet = hillshade("ft", 0.3048), of_metres = hillshade("m", 1);
  int least = 255, most = 0;
  for (std::size_t k = 0; k < of_feet.size(); ++k) {
    EXPECT_NEAR(of_feet[k], of_metres[k], 1) << k;
    least = std::min<int>(least, of_metres[k]);
    most = std::max<int>(most, of_metres[k]);
  }
  EXPECT_GT(most - least, 60);
}

}  // namespace
}  // namespace lsos
