// Light and sight on a small raster: the warning where the ground ends before the horizon that
// matters, and the effect of a coarser raster around it.
#include <fmt/format.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "system/plan_run.h"
#include "system/polar_raster.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* at = "2026-07-29T08:00:00Z";  // the Sun 4.3 degrees high, due north

struct Light {
  json answer;
  std::vector<float> shares;
};

// Light of the inner 200 m of the site.
Light light_of(const TempFolder& folder, const Words& ground) {
  Words words{"light"};
  words.insert(words.end(), ground.begin(), ground.end());
  const std::string file = folder / "light.tif";
  words.insert(words.end(), {"--at", at, "--window=-0.0378,-85.0033,0.0378,-84.9967",
                             "--resolution", "10", "-o", file, "--json"});
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  Light light;
  if (outcome.exit_code != 0) return light;
  light.answer = json::parse(outcome.out)[0];
  GDALAllRegister();
  const GDALDatasetUniquePtr map(GDALDataset::FromHandle(GDALOpen(file.c_str(), GA_ReadOnly)));
  const int columns = map->GetRasterXSize(), rows = map->GetRasterYSize();
  light.shares.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  EXPECT_EQ(map->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns, rows, light.shares.data(),
                                            columns, rows, GDT_Float32, 0, 0),
            CE_None);
  return light;
}

TEST(GroundEnd, light_on_a_small_raster_is_told_to_be_of_that_alone) {
  const TempFolder folder;
  const Light alone = light_of(folder, {raster(folder, "fine", 200, 5)});
  EXPECT_GT(alone.answer["mean_sun_fraction"].get<double>(), 0.99);
  ASSERT_TRUE(alone.answer.contains("warnings"));
  EXPECT_NEAR(alone.answer["ground_reaches_m"].get<double>(), 500, 30);
  EXPECT_THAT(alone.answer["warnings"][0].get<std::string>(),
              AllOf(HasSubstr("the ground ends before the horizon that counts"),
                    HasSubstr("Sun 4.3 deg high"), HasSubstr("--beyond")));
}

TEST(GroundEnd, light_with_a_coarse_raster_beyond_is_that_of_the_whole) {
  const TempFolder folder;
  const std::string fine = raster(folder, "fine", 200, 5),
                    coarse = raster(folder, "coarse", 260, 100);
  const Light whole = light_of(folder, {coarse});
  const Light both = light_of(folder, {fine, "--beyond", coarse});
  const double mean = whole.answer["mean_sun_fraction"].get<double>();
  EXPECT_GT(mean, 0.1);
  EXPECT_LT(mean, 0.9);
  EXPECT_NEAR(both.answer["mean_sun_fraction"].get<double>(), mean, 0.01);
  ASSERT_EQ(both.shares.size(), whole.shares.size());
  for (std::size_t k = 0; k < both.shares.size(); ++k) {
    EXPECT_NEAR(both.shares[k], whole.shares[k], 0.03) << k;
  }
  // The coarse ground ends at 13 km, which is less than ground can cast shadows from at 4.3
  // degrees.
  EXPECT_NEAR(both.answer["ground_reaches_m"].get<double>(), 13000, 300);
}

TEST(GroundEnd, nothing_is_said_where_no_ground_can_count) {
  const TempFolder folder;
  const std::string fine = raster(folder, "fine", 200, 5);
  const Light over_generated = light_of(folder, {fine, "--beyond", "LunarSouthPole"});
  EXPECT_FALSE(over_generated.answer.contains("warnings"));
  EXPECT_FALSE(over_generated.answer.contains("ground_reaches_m"));
  EXPECT_FALSE(light_of(folder, {"Craters"}).answer.contains("warnings"));
}

// Writes level ground of the Moon in cells of one degree, from 90 degrees south to 90 degrees
// north.
std::string degrees_of_moon(const TempFolder& folder, double west_deg, int columns) {
  std::string text = fmt::format("ncols {}\nnrows 180\nxllcorner {}\nyllcorner -90\ncellsize 1\n",
                                 columns, west_deg);
  for (int row = 0; row < 180; ++row) {
    for (int column = 0; column < columns; ++column) text += row == 85 ? "20 " : "0 ";
    text += '\n';
  }
  folder.write("moon.prj", R"(GEOGCS["Moon 2000",DATUM["D_Moon_2000",)"
                           R"(SPHEROID["Moon_2000_IAU_IAG",1737400,0]],)"
                           R"(PRIMEM["Reference_Meridian",0],UNIT["degree",0.0174532925199433]])");
  return folder.write("moon.asc", text);
}

Outcome light_at_new_moon(const TempFolder& folder, const std::string& raster,
                          const std::string& window) {
  return run({"light", raster, "--at", "2026-07-17T12:00:00Z", "--window=" + window, "--unit", "m",
              "-o", folder / "light.tif", "--json"});
}

// The terminator lies at 54 degrees east, the raster's edge at 58 degrees.
TEST(GroundEnd, is_told_with_the_sun_of_a_place_that_is_lit_over_it) {
  const TempFolder folder;
  const Outcome outcome = light_at_new_moon(folder, degrees_of_moon(folder, 0, 58), "10,-5,58,5");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json answer = json::parse(outcome.out)[0];
  ASSERT_TRUE(answer.contains("warnings")) << answer;
  const std::string warning = answer["warnings"][0];
  const std::size_t sun = warning.find("hide a Sun ");
  ASSERT_NE(sun, std::string::npos) << warning;
  EXPECT_NEAR(std::stod(warning.substr(sun + 11)), 0, 4) << warning;
}

TEST(GroundEnd, is_not_told_of_a_raster_around_the_body) {
  const TempFolder folder;
  const Outcome outcome =
      light_at_new_moon(folder, degrees_of_moon(folder, -180, 360), "-58,-5,58,5");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json answer = json::parse(outcome.out)[0];
  EXPECT_GT(answer["mean_sun_fraction"].get<double>(), 0.01);
  EXPECT_FALSE(answer.contains("warnings")) << answer;
  EXPECT_EQ(answer["cells_without_value"], 0);
}

TEST(GroundEnd, light_is_refused_beyond_the_reach_of_its_site) {
  const TempFolder folder;
  const std::string globe = degrees_of_moon(folder, -180, 360);
  const Outcome outcome = light_at_new_moon(folder, globe, "-70,-5,70,5");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("the map reaches 71 degrees from its site 0.0000,0.0000; up "
                                     "to 60 are allowed: give a smaller --window"));
  const Outcome whole = run({"light", globe, "--at", "2026-07-17", "-o", folder / "light.tif"});
  EXPECT_EQ(whole.exit_code, 2);
  EXPECT_THAT(whole.err, HasSubstr("up to 60 are allowed"));
}

TEST(GroundEnd, light_tells_how_many_cells_have_no_ground) {
  const TempFolder folder;
  const std::string fine = raster(folder, "fine", 200, 5);
  const Outcome outcome = run({"light", fine, "--at", at, "--window=-0.3,-85.0033,0.0378,-84.9967",
                               "--resolution", "10", "-o", folder / "light.tif", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json answer = json::parse(outcome.out)[0];
  const double cells = answer["columns"].get<double>() * answer["rows"].get<double>();
  // The window reaches from 793 m west of the site to 100 m east of it; the raster begins at 500 m
  // west.
  EXPECT_NEAR(answer["cells_without_value"].get<double>() / cells, 0.33, 0.02) << answer;
}

TEST(GroundEnd, refuses_what_cannot_lie_beyond) {
  const TempFolder folder;
  const std::string fine = raster(folder, "fine", 200, 5);
  const auto refused = [&](const std::string& name, const std::string& beyond) {
    const Outcome outcome = run({"terrain", name, "--beyond", beyond, "--at", "0,-85"});
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  EXPECT_THAT(refused(fine, raster(folder, "aside", 40, 100, 30e3)),
              HasSubstr("terrain aside.asc has no ground anywhere along the edge of fine.asc"));
  EXPECT_THAT(refused(raster(folder, "coarse", 40, 100), fine),
              HasSubstr("its cells are the finer ones: are the two exchanged?"));
  EXPECT_THAT(refused(fine, raster(folder, "mars", 40, 100, 0, mars_polar)), HasSubstr("mars.asc"));
  EXPECT_THAT(refused(fine, "BlackPoint"), HasSubstr("Earth"));
  EXPECT_THAT(refused(fine, "LunarSouthPol"), HasSubstr("did you mean 'LunarSouthPole'?"));
  EXPECT_THAT(refused(fine, folder / "missing.tif"), HasSubstr("missing.tif"));
  EXPECT_THAT(refused("Craters", fine), HasSubstr("terrain Craters is generated and has no end"));
}

TEST(GroundEnd, a_line_of_sight_across_a_hole_is_told) {
  const TempFolder folder;
  const std::string file = raster_of(folder, "hole", 40, 25, [](double, double north_m) {
    return std::abs(north_m) < 100 ? missing : 0;
  });
  // The places lie 300 m north and 300 m south of the middle.
  const Outcome lines = run({"sight", file, "--from", "0,-84.9901,2", "--to", "0,-85.0099,2",
                             "--to", "0.05,-84.9901,2", "--json"});
  ASSERT_EQ(lines.exit_code, 0) << lines.err;
  const json answer = json::parse(lines.out);
  EXPECT_EQ(answer[0]["visible"], 1);
  EXPECT_NEAR(answer[0]["ground_reaches_m"].get<double>(), 187, 20);
  EXPECT_THAT(answer[0]["warnings"][0].get<std::string>(),
              HasSubstr("--to 0,-85.0099,2: the ground on the line is not known from"));
  EXPECT_FALSE(answer[1].contains("warnings"));
  const Outcome map = run({"sight", file, "--from", "0,-84.9901,2", "--height", "2", "-o",
                           folder / "seen.tif", "--json"});
  ASSERT_EQ(map.exit_code, 0) << map.err;
  EXPECT_THAT(json::parse(map.out)[0]["warnings"][0].get<std::string>(),
              HasSubstr("of what is seen is seen over ground that is not known"));
}

// Writes a plan beside the rasters in which an SEV stays at the site for ten minutes.
std::string stay(const TempFolder& folder, const std::string& name, const Fields& more) {
  Mark info = mission(more);
  for (auto& [field, value] : info.fields) {
    if (field == "Terrain") value = "fine.asc";
    if (field == "StartTime") value = at;
  }
  return folder.write(
      name, kml({info, sev("A", "0,-85"), event("Pause", "A", 1, {{"Duration", "10 min"}})}));
}

TEST(GroundEnd, check_tells_of_it_before_anything_runs) {
  const TempFolder folder;
  raster(folder, "fine", 200, 5);
  raster(folder, "coarse", 260, 100);
  const Outcome alone = run({"check", stay(folder, "alone.kml", {})});
  EXPECT_EQ(alone.exit_code, 0);
  EXPECT_THAT(alone.out, HasSubstr("alone.kml:3: warning: MissionInfo: at the start of A, about"));
  EXPECT_THAT(alone.out, HasSubstr("the ground ends 500 m away towards the Sun, 4.3 deg high"));
  EXPECT_THAT(alone.out, HasSubstr("TerrainBeyond lays a coarser terrain"));
  const Outcome over =
      run({"check", stay(folder, "over.kml", {{"TerrainBeyond", "LunarSouthPole"}}), "--verbose"});
  EXPECT_EQ(over.exit_code, 0) << over.out;
  EXPECT_THAT(over.out, Not(HasSubstr("warning")));
  EXPECT_THAT(over.out, HasSubstr("fine.asc: beyond its end the ground is that of LunarSouthPole, "
                                  "which is synthetic"));
  const Outcome wrong =
      run({"check", stay(folder, "wrong.kml", {{"TerrainBeyond", "coarse.tif"}})});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.out, HasSubstr("MissionInfo: TerrainBeyond = 'coarse.tif': is neither the name "
                                   "of a terrain nor a file relative to the plan"));
}

TEST(GroundEnd, a_run_takes_its_light_over_the_terrain_beyond_and_says_where_that_ends) {
  const TempFolder folder;
  raster(folder, "fine", 200, 5);
  raster_of(folder, "walled", 100, 100,
            [](double x_m, double y_m) { return std::hypot(x_m, y_m) > 2000 ? 500 : 0; });
  const auto ran = [&](const std::string& name, const Fields& more) {
    const std::string into = folder / (name + "_run");
    const Outcome outcome =
        run({"run", stay(folder, name + ".kml", more), "-o", into, "--quiet", "--no-report"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return into;
  };
  const std::string alone = ran("alone", {}),
                    walled = ran("walled", {{"TerrainBeyond", "walled.asc"}});
  const json warnings = summary(alone)["warnings"];
  EXPECT_THAT(warnings, Contains(HasSubstr("light of A: in ")));
  EXPECT_THAT(warnings,
              Contains(HasSubstr("the ground ends 500 m away towards the Sun, 4.3 deg high, "
                                 "which ground up to")));
  EXPECT_GT(summary(alone)["rovers"]["A"]["solar_j"].get<double>(), 0);
  // In the shadow of the wall the end of the ground does not matter.
  EXPECT_EQ(summary(walled)["rovers"]["A"]["solar_j"], 0);
  EXPECT_THAT(summary(walled)["warnings"], Not(Contains(HasSubstr("light of A"))));
  EXPECT_EQ(query(walled + "/log.gpkg", "SELECT value FROM run WHERE key = 'terrain_beyond'"),
            "walled.asc");
  EXPECT_NE(query(walled + "/log.gpkg", "SELECT value FROM run WHERE key = 'plan_sha256'"),
            query(alone + "/log.gpkg", "SELECT value FROM run WHERE key = 'plan_sha256'"));
}

}  // namespace
}  // namespace lsos::test
