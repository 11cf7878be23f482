// Rasters of 40,000 x 40,000 cells: their cost in memory, and the advice that is given. The files
// are sparse, so that they take no disk space.
#include <fmt/format.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <nlohmann/json.hpp>

#include "support/sanitizer.h"
#include "system/run_folder.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr char polar_crs[] = "+proj=stere +lat_0=-90 +lon_0=0 +R=1737400 +units=m +no_defs";

// A tiled GeoTIFF of zeros with 1 m cells, with the pole in its middle; `marked` blocks hold
// `height_m` instead.
struct SparseRaster {
  int side = 0;  // in cells
  std::vector<std::pair<int, int>> marked = {};
  float height_m = 1;
  bool has_overview = false;
  GDALDataType type = GDT_Float32;

  std::string write(const TempFolder& folder, const std::string& name) const {
    GDALAllRegister();
    const char* const options[] = {"TILED=YES", "SPARSE_OK=TRUE", "BIGTIFF=YES", nullptr};
    const std::string file = folder / name;
    GDALDatasetUniquePtr dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), side, side, 1, type, const_cast<char**>(options)));
    if (!dataset) throw std::runtime_error("cannot write " + file);
    double transform[6] = {-side / 2.0, 1, 0, side / 2.0, 0, -1};
    OGRSpatialReference crs;
    crs.importFromProj4(polar_crs);
    dataset->SetGeoTransform(transform);
    dataset->SetSpatialRef(&crs);
    std::vector<float> block(256 * 256, height_m);
    for (const auto& [column, row] : marked) {
      EXPECT_EQ(
          dataset->GetRasterBand(1)->RasterIO(GF_Write, 256 * column, 256 * row, 256, 256,
                                              block.data(), 256, 256, GDT_Float32, 0, 0, nullptr),
          CE_None);
    }
    if (has_overview) {
      CPLConfigOptionSetter sparse("SPARSE_OK_OVERVIEW", "TRUE", false);
      int factor = 16;
      EXPECT_EQ(dataset->BuildOverviews("NONE", 1, &factor, 0, nullptr, nullptr, nullptr), CE_None);
    }
    return file;
  }
};

// 10 s of driving, 100 m from the pole.
std::string drive_on(const std::string& raster, const TempFolder& folder) {
  constexpr const char* start = "0,-89.9967";
  return folder.write("big.kml",
                      kml({{"MissionInfo",
                            {{"Planet", "Moon"}, {"StartTime", "2026-01-01"}, {"Terrain", raster}},
                            ""},
                           sev("A", start),
                           event("Route", "A", 1, {{"Speed", "2"}}, point("0,-89.9963"))}));
}

TEST(BigRaster, without_overviews_is_advised_to_have_some) {
  const TempFolder folder;
  const std::string file = SparseRaster{.side = 10'240}.write(folder, "bare.tif");
  const Outcome outcome = run({"check", drive_on(file, folder)});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr(fmt::format("warning: raster '{0}' has 10240 x 10240 cells and no "
                                    "overviews, so that a look from afar reads all of it; make "
                                    "them once with: gdaladdo -r average {0} 2 4 8 16",
                                    file)));
}

// Overviews are not used when they may have averaged nodata marks into heights.
TEST(BigRaster, with_overviews_that_are_not_used_is_advised_to_declare_its_marks) {
  const TempFolder folder;
  const std::string file =
      SparseRaster{.side = 10'240, .has_overview = true}.write(folder, "undeclared.tif");
  const Outcome outcome = run({"check", drive_on(file, folder)});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("its overviews are not used, for they may have averaged "
                                     "-32768 or -32767, which mark missing samples, with heights; "
                                     "declare first what marks them: gdal_edit.py -a_nodata "
                                     "-32768 " +
                                     file));
}

TEST(BigRaster, with_overviews_or_of_moderate_size_needs_no_advice) {
  const TempFolder folder;
  const std::string with =
      SparseRaster{.side = 10'240, .has_overview = true, .type = GDT_UInt16}.write(folder,
                                                                                   "with.tif");
  const std::string moderate = SparseRaster{.side = 9'984}.write(folder, "moderate.tif");
  for (const std::string& file : {with, moderate}) {
    const Outcome outcome = run({"check", drive_on(file, folder)});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, Not(HasSubstr("overviews"))) << file;
  }
}

TEST(BigRaster, is_driven_on_in_little_memory) {
  const TempFolder folder;
  const std::string file = SparseRaster{.side = 40'000}.write(folder, "big.tif");
  // The report's pictures would take some 150 MB more.
  const Outcome outcome =
      run({drive_on(file, folder), "-o", folder / "run", "--quiet", "--no-report"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(summary(folder / "run")["warnings"].dump(), HasSubstr("overviews"));
  // With a sanitizer, its own memory would be measured. All above holds with it too.
  if (is_sanitized) return;
  rusage used;  // ru_maxrss: of the largest child process
  ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &used), 0);
  EXPECT_LT(used.ru_maxrss, 300'000) << "kB";
  EXPECT_GT(used.ru_maxrss, 10'000) << "kB";
}

std::string terrain_hash(const std::string& raster, const TempFolder& folder) {
  const Outcome outcome = run({drive_on(raster, folder), "-o", folder / "run", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  return query(folder / "run" / "log.gpkg", "select value from run where key = 'terrain_sha256'");
}

// A raster's hash does not cover every cell, but its time of change is noticed.
TEST(BigRaster, that_was_changed_is_planned_on_again) {
  const TempFolder folder;
  const std::string raster = SparseRaster{.side = 8192}.write(folder, "a.tif");
  const std::string plan = folder.write(
      "way.kml", kml({{"MissionInfo",
                       {{"Planet", "Moon"}, {"StartTime", "2026-01-01"}, {"Terrain", raster}},
                       ""},
                      sev("A", "0,-89.9967"),
                      event("PathPlanRoute", "A", 1, {}, point("0,-89.996"))}));
  const auto kept = [&] {
    const Outcome outcome = run({"check", plan});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return read_text(plan + ".routes");
  };
  const std::string first = kept();
  EXPECT_EQ(kept(), first);
  const auto changed = std::filesystem::last_write_time(raster);
  std::filesystem::last_write_time(raster, changed + std::chrono::seconds(1));
  EXPECT_NE(kept(), first);
}

// The raster has 32 x 32 blocks, of which every eighth is read.
TEST(BigRaster, has_a_hash_of_what_it_holds) {
  const TempFolder folder;
  SparseRaster raster{.side = 8192};
  for (int column = 0; column < 32; ++column) raster.marked.push_back({column, 5});
  const std::string first = terrain_hash(raster.write(folder, "a.tif"), folder);
  EXPECT_EQ(first.size(), 64u);
  EXPECT_EQ(terrain_hash(raster.write(folder, "b.tif"), folder), first);
  raster.height_m = 1.001f;
  EXPECT_NE(terrain_hash(raster.write(folder, "c.tif"), folder), first);
  raster.height_m = 1;
  for (int column = 0; column < 4; ++column) {
    SparseRaster more = raster;
    more.marked.push_back({column, 20});
    EXPECT_NE(terrain_hash(more.write(folder, "d.tif"), folder), first) << column;
  }
}

}  // namespace
}  // namespace lsos::test
