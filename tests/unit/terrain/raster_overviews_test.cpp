// Overviews of a file serve coarse levels where none can have averaged marks of missing samples.
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "ground_fixture.h"

namespace lsos {
namespace {

constexpr double ground_m = 100;
constexpr double overview_m = 77;
// Side of a raster that is read whole when it is opened, and of one that is not.
constexpr int small = 256, large = 1280;

// Level ground of 1 m about 0, 0 on the Moon. One cell in 256 may hold a mark instead.
struct OverviewRaster {
  GDALDataType type = GDT_Float32;
  std::optional<double> declared = {};
  std::optional<double> mark = {};
  bool has_mask = false;
  int side = large;

  // Writes overviews of another height, so that a sample shows whether it came from them.
  std::string write_aside(double height_m = overview_m) const {
    const auto [file, dataset] = create("aside");
    build(*dataset, "NONE");
    GDALRasterBand& band = *dataset->GetRasterBand(1);
    for (int k = 0; k < band.GetOverviewCount(); ++k) {
      EXPECT_EQ(band.GetOverview(k)->Fill(height_m), CE_None);
      if (has_mask) {
        EXPECT_EQ(band.GetOverview(k)->GetMaskBand()->Fill(255), CE_None);
      }
    }
    return file;
  }

  // Writes overviews as gdaladdo makes them.
  std::string write_averaged() const {
    const auto [file, dataset] = create("averaged");
    build(*dataset, "AVERAGE");
    return file;
  }

 private:
  std::pair<std::string, GDALDatasetUniquePtr> create(const std::string& name) const {
    const std::string file = "/vsimem/" + name + ".tif";
    GDALAllRegister();
    CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
    GDALDatasetUniquePtr dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), side, side, 1, type, nullptr));
    double transform[] = {-side / 2.0, 1, 0, side / 2.0, 0, -1};
    dataset->SetGeoTransform(transform);
    OGRSpatialReference crs;
    crs.importFromProj4("+proj=eqc +R=1737400 +units=m");
    dataset->SetSpatialRef(&crs);
    GDALRasterBand& band = *dataset->GetRasterBand(1);
    if (declared) band.SetNoDataValue(*declared);
    if (has_mask) {
      EXPECT_EQ(dataset->CreateMaskBand(GMF_PER_DATASET), CE_None);
      EXPECT_EQ(band.GetMaskBand()->Fill(255), CE_None);
    }
    for (int j = 0; j < side; ++j) {
      std::vector<double> row(static_cast<std::size_t>(side), ground_m);
      for (int i = 8; mark && j % 16 == 8 && i < side; i += 16) row[i] = *mark;
      EXPECT_EQ(band.RasterIO(GF_Write, 0, j, side, 1, row.data(), side, 1, GDT_Float64, 0, 0),
                CE_None);
    }
    return {file, std::move(dataset)};
  }

  static void build(GDALDataset& dataset, const char* resampling) {
    const int factors[] = {2, 4, 8};
    EXPECT_EQ(dataset.BuildOverviews(resampling, 3, factors, 0, nullptr, nullptr, nullptr),
              CE_None);
  }
};

// Lowest height at a coarse level, m.
double lowest_m(const Ground& ground, int side) {
  Ground::Probe far(ground, 8);
  double lowest_m = std::numeric_limits<double>::infinity();
  for (double x_m = -side / 2.0 + 40; x_m < side / 2.0 - 40; x_m += 5) {
    for (const double y_m : {-60.0, -3.0, 25.0, 71.0}) {
      const GroundSample sample = far.sample({x_m, y_m, 0});
      if (sample.is_ground()) lowest_m = std::min(lowest_m, sample.elevation_m);
    }
  }
  return lowest_m;
}

bool is_used(const OverviewRaster& raster, std::optional<double> nodata_said = {}) {
  TerrainSpec spec = raster_terrain(raster.write_aside());
  std::get<RasterSurface>(spec.layers[0]).nodata = nodata_said;
  const Ground ground(spec, site_on("Moon", 0, 0), 0);
  const GroundSample sample = Ground::Probe(ground, 8).sample({3, 3, 0});
  EXPECT_TRUE(std::abs(sample.elevation_m - overview_m) < 1e-9 ||
              std::abs(sample.elevation_m - ground_m) < 1e-9)
      << sample.elevation_m;
  return sample.elevation_m < (ground_m + overview_m) / 2;
}

TEST(RasterOverviews, make_no_pits_of_marks_that_gdal_averages) {
  for (const int side : {small, large}) {
    for (const OverviewRaster& raster :
         {OverviewRaster{.mark = -32768}, OverviewRaster{.mark = -32767},
          OverviewRaster{.declared = -9999, .mark = -32768},
          OverviewRaster{.type = GDT_Int16, .declared = -9999, .mark = -32768},
          OverviewRaster{.type = GDT_Int32, .mark = -32768},
          OverviewRaster{.type = GDT_Int16, .mark = -32768, .has_mask = true},
          OverviewRaster{.mark = -32768, .has_mask = true}, OverviewRaster{.mark = -3.4e38}}) {
      OverviewRaster sized = raster;
      sized.side = side;
      const Ground ground(raster_terrain(sized.write_averaged()), site_on("Moon", 0, 0), 0);
      EXPECT_NEAR(lowest_m(ground, side), ground_m, 1e-6)
          << side << " " << GDALGetDataTypeName(raster.type) << " " << raster.has_mask;
    }
  }
}

TEST(RasterOverviews, are_used_where_gdal_leaves_out_all_marks) {
  EXPECT_TRUE(is_used({.type = GDT_Byte}));
  EXPECT_TRUE(is_used({.type = GDT_UInt16}));
  EXPECT_TRUE(is_used({.type = GDT_UInt16, .has_mask = true}));
  EXPECT_TRUE(is_used({.type = GDT_Int16, .declared = -32768}));
  EXPECT_TRUE(is_used({.type = GDT_Int16, .declared = -32767}));
  EXPECT_TRUE(is_used({.declared = -32768}));
  // A value given by the user stands for all marks.
  EXPECT_TRUE(is_used({.declared = -9999}, -9999));
  EXPECT_TRUE(is_used({.type = GDT_Int16, .declared = -9999}, -9999));
}

TEST(RasterOverviews, are_not_used_where_marks_may_stand_in_what_was_not_seen) {
  EXPECT_FALSE(is_used({}));
  EXPECT_FALSE(is_used({.declared = -9999}));
  EXPECT_FALSE(is_used({.type = GDT_Int16}));
  EXPECT_FALSE(is_used({.type = GDT_Int16, .declared = -9999}));
  EXPECT_FALSE(is_used({.has_mask = true}));
  EXPECT_FALSE(is_used({.declared = -9999}, -1));
}

TEST(RasterOverviews, are_used_of_a_raster_that_was_seen_to_hold_no_marks) {
  EXPECT_TRUE(is_used({.side = small}));
  EXPECT_TRUE(is_used({.declared = -9999, .side = small}));
  EXPECT_TRUE(is_used({.type = GDT_Int16, .declared = -9999, .side = small}));
  EXPECT_TRUE(is_used({.has_mask = true, .side = small}));
  EXPECT_FALSE(is_used({.mark = -32768, .side = small}));
}

TEST(RasterOverviews, are_in_the_hash_where_they_are_used) {
  const auto hash = [](const OverviewRaster& raster, double height_m) {
    return Ground(raster_terrain(raster.write_aside(height_m)), site_on("Moon", 0, 0), 0).hash();
  };
  for (const bool has_mask : {false, true}) {
    const OverviewRaster used{.type = GDT_UInt16, .has_mask = has_mask},
        unused{.has_mask = has_mask};
    EXPECT_EQ(hash(used, 90), hash(used, 90));
    EXPECT_NE(hash(used, 90), hash(used, 91));
    EXPECT_EQ(hash(unused, 90), hash(unused, 91));
  }
}

}  // namespace
}  // namespace lsos
