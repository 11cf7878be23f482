// Samples that another band marks as missing: an alpha band, or the file's mask.
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "ground_fixture.h"

namespace lsos {
namespace {

constexpr int columns = 256, rows = 64;
constexpr int first_masked = 128;  // column
constexpr double masked_height_m = 40;

enum class Mask { none, alpha, file };

// A level raster of 1 m about 0, 0 on the Moon. Its eastern half holds heights of 0 and is masked;
// a nodata value, where there is one, stands in the westernmost eight columns.
struct MaskedRaster {
  Mask mask;
  bool has_nodata = false;
  bool has_overviews = false;

  std::string write(const std::string& name) const {
    const std::string file = "/vsimem/" + name + ".tif";
    GDALAllRegister();
    CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
    const int bands = mask == Mask::alpha ? 2 : 1;
    GDALDatasetUniquePtr dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), columns, rows, bands, GDT_Float32, nullptr));
    double transform[] = {-columns / 2.0, 1, 0, rows / 2.0, 0, -1};
    dataset->SetGeoTransform(transform);
    OGRSpatialReference crs;
    crs.importFromProj4("+proj=eqc +R=1737400 +units=m");
    dataset->SetSpatialRef(&crs);
    if (has_nodata) dataset->GetRasterBand(1)->SetNoDataValue(-9999);
    fill(*dataset->GetRasterBand(1), [this](int column) {
      if (column >= first_masked) return 0.0;
      return has_nodata && column < 8 ? -9999 : masked_height_m;
    });
    const auto shown = [](int column) { return column >= first_masked ? 0.0 : 255.0; };
    if (mask == Mask::alpha) {
      dataset->GetRasterBand(2)->SetColorInterpretation(GCI_AlphaBand);
      fill(*dataset->GetRasterBand(2), shown);
    } else if (mask == Mask::file) {
      EXPECT_EQ(dataset->CreateMaskBand(GMF_PER_DATASET), CE_None);
      fill(*dataset->GetRasterBand(1)->GetMaskBand(), shown);
    }
    const int factors[] = {2, 4};
    if (has_overviews) {
      EXPECT_EQ(dataset->BuildOverviews("AVERAGE", 2, factors, 0, nullptr, nullptr, nullptr),
                CE_None);
    }
    return file;
  }

 private:
  template <class F>
  static void fill(GDALRasterBand& band, const F& of_column) {
    std::vector<double> row(columns);
    for (int i = 0; i < columns; ++i) row[static_cast<std::size_t>(i)] = of_column(i);
    for (int j = 0; j < rows; ++j) {
      EXPECT_EQ(band.RasterIO(GF_Write, 0, j, columns, 1, row.data(), columns, 1, GDT_Float64, 0, 0,
                              nullptr),
                CE_None);
    }
  }
};

SiteFrame masked_moon() { return site_on("Moon", 0, 0); }

void expect_masked(const Ground& ground, bool has_nodata, double resolution_m) {
  Ground::Probe probe(ground, resolution_m);
  const double aside_m = 1 + resolution_m;
  for (const double y : {-20.0, 3.3, 25.0}) {
    EXPECT_FALSE(probe.sample({aside_m, y, 0}).is_ground());
    EXPECT_FALSE(probe.sample({100, y, 0}).is_ground());
    EXPECT_EQ(probe.sample({-125, y, 0}).is_ground(), !has_nodata);
    for (const double x : {-aside_m, -30.0, -110.0}) {
      EXPECT_NEAR(probe.sample({x, y, 0}).elevation_m, masked_height_m, 1e-9)
          << x << " " << resolution_m;
    }
  }
}

TEST(RasterMask, leaves_no_ground_from_close_by_and_from_afar) {
  for (const Mask mask : {Mask::alpha, Mask::file}) {
    for (const bool has_nodata : {false, true}) {
      for (const bool has_overviews : {false, true}) {
        const MaskedRaster raster{mask, has_nodata, has_overviews};
        const Ground ground(raster_terrain(raster.write("masked")), masked_moon(), 0);
        for (const double resolution_m : {0.0, 4.0}) {
          SCOPED_TRACE(::testing::Message()
                       << static_cast<int>(mask) << has_nodata << has_overviews << resolution_m);
          expect_masked(ground, has_nodata, resolution_m);
        }
      }
    }
  }
}

// A nodata value given by the user replaces the file's, not its alpha band.
TEST(RasterMask, stays_when_the_user_says_what_stands_for_none) {
  TerrainSpec spec = raster_terrain(MaskedRaster{Mask::alpha, true}.write("said"));
  std::get<RasterSurface>(spec.layers[0]).nodata = -9999;
  expect_masked(Ground(spec, masked_moon(), 0), true, 0);
}

TEST(RasterMask, is_in_the_hash) {
  const auto hash = [](Mask mask) {
    return Ground(raster_terrain(MaskedRaster{mask}.write("hash")), masked_moon(), 0).hash();
  };
  EXPECT_NE(hash(Mask::alpha), hash(Mask::none));
  EXPECT_NE(hash(Mask::file), hash(Mask::none));
}

TEST(RasterMask, lets_a_coarser_layer_show) {
  TerrainSpec spec = raster_terrain(MaskedRaster{Mask::alpha}.write("above"));
  spec.layers.push_back(plane_terrain(7).layers.front());
  const Ground ground(spec, masked_moon(), 0);
  Ground::Probe probe(ground);
  EXPECT_NEAR(probe.sample({60, 0, 0}).elevation_m, 7, 1e-6);
  EXPECT_NEAR(probe.sample({-60, 0, 0}).elevation_m, masked_height_m, 1e-6);
}

}  // namespace
}  // namespace lsos
