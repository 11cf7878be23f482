// Ground beside a plan that would take for ever or all memory to read.
#include <fmt/format.h>

#include <fstream>

#include "system/bounded_folder.h"
#include "system/foreign_ground.h"
#include "system/plan_text.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;

class BoundedGround : public ::testing::TestWithParam<Folder> {};

TEST_P(BoundedGround, check_ends_soon) { expect_end(GetParam(), TempFolder()); }

std::string vrt_of(const std::vector<std::string>& sources, std::int64_t cells = 40) {
  std::string bands;
  for (const std::string& source : sources) {
    bands += fmt::format(
        "<SimpleSource><SourceFilename relativeToVRT='1'>{}</SourceFilename>"
        "<SourceBand>1</SourceBand></SimpleSource>",
        source);
  }
  return fmt::format(
      "<VRTDataset rasterXSize='{0}' rasterYSize='{0}'><SRS>{1}</SRS>"
      "<GeoTransform>30.98, 0.001, 0, 20.02, 0, -0.001</GeoTransform>"
      "<VRTRasterBand dataType='Float32' band='1'>{2}</VRTRasterBand></VRTDataset>",
      cells, crs_of_moon, bands);
}

Folder on_ground(const std::string& name, const std::string& raster,
                 const std::function<void(const TempFolder&)>& fill, int exit_code,
                 const std::vector<std::string>& told) {
  return {name,
          [=](const TempFolder& folder) {
            write_raster(folder, "dem");
            fill(folder);
            folder.write(
                "plan.kml",
                kml({{"MissionInfo",
                      {{"Planet", "Moon"}, {"StartTime", "2026-07-01"}, {"Terrain", raster}},
                      ""},
                     sev("A", "31,20"),
                     event("Pause", "A", 1, {{"Duration", "5 s"}})}));
          },
          exit_code, told};
}

// A VRT that goes on with a hole, in its folder or in an archive there.
Folder large_vrt(const std::string& name, const std::string& file, std::uintmax_t bytes) {
  const auto fill = [=](const TempFolder& folder) {
    const fs::path vrt = folder / fs::path(file).filename();
    std::ofstream(vrt) << vrt_of({"dem.asc"});
    fs::resize_file(vrt, bytes);
    if (file == vrt.filename()) return;
    const Outcome zipped = run_command({"zip", "-q", "v0.zip", vrt.filename()}, {folder.path()});
    EXPECT_EQ(zipped.exit_code, 0);
  };
  return on_ground(name, file, fill, 2,
                   {"is larger than 64 MiB; gdal_translate makes a GeoTIFF of it"});
}

const std::vector<Folder> grounds = {
    on_ground("vrts_that_name_each_other", "v0a.vrt",
              [](const TempFolder& folder) {
                constexpr int depth = 22;
                for (int i = 0; i < depth; ++i) {
                  for (const char side : {'a', 'b'}) {
                    folder.write(fmt::format("v{}{}.vrt", i, side),
                                 i + 1 == depth ? vrt_of({"dem.asc"})
                                                : vrt_of({fmt::format("v{}a.vrt", i + 1),
                                                          fmt::format("v{}b.vrt", i + 1)}));
                  }
                }
              },
              2, {"v0a.vrt", "it opens more than 1000 VRTs at once"}),
    on_ground("vrts_in_a_circle", "v0.vrt",
              [](const TempFolder& folder) {
                folder.write("v0.vrt", vrt_of({"v1.vrt"}));
                folder.write("v1.vrt", vrt_of({"v0.vrt"}));
              },
              2, {"v0.vrt", "cannot be read: Recursion detected"}),
    on_ground("vrt_of_some_vrts", "v0.vrt",
              [](const TempFolder& folder) {
                folder.write("v0.vrt", vrt_of({"v1.vrt", "v1.vrt", "./v1.vrt"}));
                folder.write("v1.vrt", vrt_of({"dem.asc", "./dem.asc"}));
              },
              0, {}),
    on_ground("raster_of_more_cells_than_can_be_counted", "v0.vrt",
              [](const TempFolder& folder) { folder.write("v0.vrt", vrt_of({}, 2'147'483'647)); },
              2, {"v0.vrt", "1000000000 x 1000000000 are the most"}),
    on_ground("raster_with_a_pipe_beside_it", "dem.asc",
              [](const TempFolder& folder) {
                fs::remove(folder / "dem.prj");
                EXPECT_EQ(mkfifo((folder / "dem.prj").c_str(), 0600), 0);
              },
              2, {"dem.asc"}),
    on_ground("raster_with_a_text_of_100_gib_beside_it", "dem.asc",
              [](const TempFolder& folder) {
                fs::remove(folder / "dem.prj");
                make_sparse(folder / "dem.prj");
              },
              2, {"dem.asc", "has no coordinate reference system"}),
    large_vrt("vrt_of_100_gib", "v0.vrt", hundred_gib),
    large_vrt("vrt_of_100_gib_in_capitals", "v0.VRT", hundred_gib),
    large_vrt("vrt_of_100_gib_that_is_called_a_geotiff", "v0.tif", hundred_gib),
    large_vrt("vrt_of_80_mib_in_an_archive", "/vsizip/v0.zip/v0.vrt", std::uintmax_t{80} << 20),
    on_ground("table_of_points_of_66_mib", "points.txt",
              [](const TempFolder& folder) {
                fs::rename(folder / "dem.asc", folder / "points.txt");
                fs::rename(folder / "dem.prj", folder / "points.prj");
                std::ofstream(folder / "points.txt", std::ios::app)
                    << std::string(std::size_t{66} << 20, '\n');
              },
              0, {}),
};
INSTANTIATE_TEST_SUITE_P(, BoundedGround, ::testing::ValuesIn(grounds),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace lsos::test
