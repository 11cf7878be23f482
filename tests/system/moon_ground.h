// Ground made for a test about 0,0 of the Moon, plans of rovers on it, and their runs.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "system/run_folder.h"

namespace lsos::test {

inline constexpr double moon_radius_m = 1737400;

// Coordinates "lon,lat" of a place x_m east and y_m north of the Moon's 0,0.
inline std::string place(double x_m, double y_m) {
  const double deg_pm = 180 / std::numbers::pi / moon_radius_m;
  return fmt::format("{:.9f},{:.9f}", x_m * deg_pm, y_m * deg_pm);
}

// Writes a raster of the Moon around 0,0 with cells of 0.5 m.
inline void write_raster(const TempFolder& folder, const std::string& name, int cells,
                         const std::function<double(double x_m, double y_m)>& height_m) {
  const double half_m = cells * 0.25;
  std::string text = fmt::format(
      "ncols {0}\nnrows {0}\nxllcorner {1}\nyllcorner {1}\ncellsize 0.5\nNODATA_value -9999\n",
      cells, -half_m);
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      text += fmt::format("{:.4f} ",
                          height_m(-half_m + (column + 0.5) * 0.5, half_m - (row + 0.5) * 0.5));
    }
    text += "\n";
  }
  folder.write("terrain/" + name + ".asc", text);
  folder.write("terrain/" + name + ".prj",
               R"(PROJCS["Moon equirectangular",GEOGCS["Moon 2000",DATUM["D_Moon_2000",)"
               R"(SPHEROID["Moon_2000_IAU_IAG",1737400.0,0.0]],PRIMEM["Greenwich",0],)"
               R"(UNIT["Degree",0.0174532925199433]],PROJECTION["Equidistant_Cylindrical"],)"
               R"(PARAMETER["False_Easting",0],PARAMETER["False_Northing",0],)"
               R"(PARAMETER["Central_Meridian",0],PARAMETER["Standard_Parallel_1",0],)"
               R"(UNIT["Meter",1]])");
}

inline void write_terrain(const TempFolder& folder, const std::string& name,
                          const std::string& surface, const std::string& soil) {
  folder.write("terrain/" + name + ".lua",
               fmt::format("local lsos = require 'lsos'\nreturn lsos.terrain {{ api = 1, "
                           "doc = 'Test.', surface = {}, soil = {} }}\n",
                           surface, soil));
}

inline Mark rover(const std::string& type, const std::string& id, const std::string& coordinates,
                  const Fields& more = {}) {
  Fields fields{{"RoverId", id}, {"RoverType", type}};
  fields.insert(fields.end(), more.begin(), more.end());
  return {"Rover", fields, point(coordinates)};
}

struct RunResult {
  Outcome outcome;
  nlohmann::json summary;
  std::filesystem::path log;

  std::string event(const char* key, std::size_t i = 0) const { return summary["events"][i][key]; }
};

inline RunResult run_plan(const TempFolder& folder, const std::vector<Mark>& marks) {
  const std::string plan = folder.write("plan.kml", kml(marks));
  RunResult result{
      run({plan, "-o", folder / "run", "--quiet", "--no-report"}), {}, folder / "run" / "log.gpkg"};
  EXPECT_EQ(result.outcome.err, "");
  result.summary = summary(folder / "run");
  return result;
}

inline Mark on(const std::string& terrain, const Fields& more = {}) {
  Fields fields{{"Planet", "Moon"}, {"StartTime", "2026-01-01"}, {"Terrain", terrain}};
  fields.insert(fields.end(), more.begin(), more.end());
  return {"MissionInfo", fields, ""};
}

}  // namespace lsos::test
