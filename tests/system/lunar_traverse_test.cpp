// plans/lunar_traverse.kml, the paper's first study: checks of its log, row by row. What a planner
// expects of it is checked in tests/scenarios/lunar_traverse.lua.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>

#include "base/units.h"
#include "record/log.h"
#include "system/run_folder.h"
#include "system/source_files.h"
#include "terrain/detail/craters.h"
#include "terrain/grid/stereographic.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;

const fs::path plan = repository() / "plans" / "lunar_traverse.kml";

void expect_energy_to_close(const std::vector<SampleRow>& rows) {
  const double start_j = rows.front().energy_j;
  for (const SampleRow& row : rows) {
    const double in_j = row.solar_j + row.external_j;
    const double out_j = row.load_j + row.drive_j + row.loss_j;
    // Tolerance: 1e-9 of the energy that flowed, and the rounding of a number of 115 MJ.
    const double within_j = 1e-9 * (in_j + out_j) + 1e-15 * start_j;
    ASSERT_NEAR(row.energy_j, start_j + in_j - out_j, within_j) << seconds(row.time);
    ASSERT_NEAR(row.energy_rate_w,
                row.solar_w + row.external_w - row.load_w - row.drive_w - row.loss_w, 1e-9);
  }
}

void expect_light_at_stops(const std::vector<SampleRow>& rows) {
  std::map<std::string, int> count;
  for (const SampleRow& row : rows) {
    if (!row.event.starts_with("Stop ")) continue;
    ++count[row.event];
    if (row.event == "Stop 1" || row.event == "Stop 4") {
      ASSERT_GT(row.energy_rate_w, 0) << row.event << " " << seconds(row.time);
    } else {
      ASSERT_EQ(row.solar_w, 0) << row.event << " " << seconds(row.time);
      ASSERT_EQ(row.energy_rate_w, -(row.load_w + row.loss_w)) << row.event;
    }
  }
  EXPECT_EQ(count.size(), 4u);
  for (const auto& [stop, samples] : count) EXPECT_GT(samples, 30 * 30) << stop;
}

void expect_half_a_hertz(const std::vector<SampleRow>& rows) {
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    ASSERT_EQ(rows[k].time, from_seconds(2.0 * static_cast<double>(k)));
  }
}

void expect_slip(const std::vector<SampleRow>& rows) {
  int slipping = 0, driving = 0;
  for (const SampleRow& row : rows) {
    driving += row.speed_mps > 1;
    slipping += row.speed_mps > 1 && std::abs(row.slip_max) > 0.01;
  }
  EXPECT_GT(driving, 500);
  EXPECT_GT(slipping, 0.8 * driving);
}

void expect_earth_to_come_and_go(const LogReader& log) {
  std::vector<SightIntervalRow> seen;
  for (const SightIntervalRow& row : log.sight_intervals()) {
    if (row.from_id == "SEV1" && row.to_id == "Earth" && row.kind == "visible") seen.push_back(row);
  }
  ASSERT_GE(seen.size(), 2u);
  EXPECT_EQ(seen.front().start, SimTime{});
  double dark_s = 0;  // longest gap
  for (std::size_t k = 1; k < seen.size(); ++k) {
    dark_s = std::max(dark_s, seconds(seen[k].start - seen[k - 1].end));
  }
  EXPECT_GT(dark_s, 3600) << "on the crater's floor";
}

// Points of a line at distances of 0.3 m or less, about the width of a wheel.
std::vector<PlanePoint> densified(const std::vector<PlanePoint>& line) {
  std::vector<PlanePoint> points;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const double x_m = line[k + 1].x_m - line[k].x_m, y_m = line[k + 1].y_m - line[k].y_m;
    const int steps = std::max(1, static_cast<int>(std::hypot(x_m, y_m) / 0.3));
    for (int i = 0; i < steps; ++i) {
      points.push_back({line[k].x_m + x_m * i / steps, line[k].y_m + y_m * i / steps});
    }
  }
  return points;
}

// Number of craters that the line crosses, of those about as large as the rover, 4.5 to 20 m, with
// walls steeper than SEV climbs in ApolloNominal, 22 degrees. The wall of a bowl of depth d and
// diameter D has slope 4 d / D.
int craters_on(const std::vector<PlanePoint>& line) {
  CraterPopulation population;  // of terrain/LunarSouthPole.lua
  population.age_gyr = 3.9;
  population.diameter_min_m = 1;
  population.diameter_max_m = 2000;
  PlaneRectangle box{line.front(), line.front()};
  for (const PlanePoint& p : line) {
    box.low = {std::min(box.low.x_m, p.x_m), std::min(box.low.y_m, p.y_m)};
    box.high = {std::max(box.high.x_m, p.x_m), std::max(box.high.y_m, p.y_m)};
  }
  int through = 0, steep = 0;
  const std::vector<PlanePoint> points = densified(line);
  for (const Crater& crater : craters_touching(population, 0, box, 4.5, 20)) {
    if (4 * crater.depth_m < std::tan(radians(22)) * crater.diameter_m) continue;
    ++steep;
    through += std::ranges::any_of(points, [&](const PlanePoint& p) {
      return std::hypot(p.x_m - crater.centre.x_m, p.y_m - crater.centre.y_m) <
             crater.diameter_m / 2;
    });
  }
  EXPECT_GT(steep, 300) << "in the area";
  return through;
}

void expect_to_dodge_craters(const std::vector<SampleRow>& rows) {
  const Stereographic map(*find_body("Moon"), 0, -std::numbers::pi / 2);
  std::vector<PlanePoint> driven, drawn;
  for (const SampleRow& row : rows) driven.push_back(map.at(row.place));
  const std::string text = read_text(plan);
  const std::regex line("<LineString>[^]*?<coordinates>([^<]*)</coordinates>"),
      point("([-0-9.]+),([-0-9.]+)");
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it) {
    const std::string points = (*it)[1];
    for (std::sregex_iterator p(points.begin(), points.end(), point); p != end; ++p) {
      drawn.push_back(map.at(geodetic_from_degrees(std::stod((*p)[1]), std::stod((*p)[2]))));
    }
  }
  const int straight = craters_on(drawn), dodged = craters_on(driven);
  std::printf("craters on the way: drawn %d, driven %d\n", straight, dodged);
  EXPECT_EQ(dodged, 0);
  EXPECT_GT(straight, 20);
}

// Share of the driving rows that are samples of the overlay.
double share_of_drive(const std::string& overlay, const std::vector<SampleRow>& rows) {
  const std::regex speed("<SimpleData name=\"speed_mps\">([-0-9.e]+)<");
  const auto is_driving = [](double speed_mps) { return speed_mps > 0.5; };
  int shown = 0;
  for (std::sregex_iterator at(overlay.begin(), overlay.end(), speed), end; at != end; ++at) {
    shown += is_driving(std::stod((*at)[1]));
  }
  return shown / static_cast<double>(std::ranges::count_if(
                     rows, is_driving, [](const SampleRow& row) { return row.speed_mps; }));
}

void expect_overlay(const fs::path& file, const std::vector<SampleRow>& rows) {
  const std::string text = read_text(file);
  const auto count = [&](const std::string& what) {
    std::size_t found = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  const std::size_t samples = count("schemaUrl=\"#lsos_samples");
  EXPECT_GT(share_of_drive(text, rows), 0.9);
  EXPECT_LE(samples, 2000u);
  EXPECT_EQ(count("<gx:Track>"), 1u);
  EXPECT_LE(count("<gx:coord>"), 1500u);
  EXPECT_GT(count("<gx:coord>"), 1000u);
  EXPECT_LT(text.size(), 3'000'000u);
}

TEST(LunarTraverse, is_what_the_paper_tells) {
  const TempFolder folder;
  const Outcome outcome = run({plan, "-o", folder / "run", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const LogReader log(folder / "run" / "log.gpkg");
  const std::vector<SampleRow> rows = log.samples();
  expect_energy_to_close(rows);
  expect_light_at_stops(rows);
  expect_half_a_hertz(rows);
  expect_slip(rows);
  expect_earth_to_come_and_go(log);
  expect_to_dodge_craters(rows);
  expect_overlay(folder / "run" / "overlay.kml", rows);
  const auto rover = summary(folder / "run")["rovers"]["SEV1"];
  EXPECT_NEAR(rover["drive_s"].get<double>(), 1800, 300) << "driven";
  EXPECT_NEAR(seconds(rows.back().time), 5 * 3600, 600);
  EXPECT_TRUE(fs::exists(folder / "run" / "report.html"));
}

// The README promises that one changed line is enough.
TEST(LunarTraverse, is_planned_on_a_raster_by_one_changed_line) {
  const TempFolder folder;
  const Outcome exported = run({"terrain", "LunarSouthPole", "--site", "80,-84.7", "--window",
                                "79.95,-84.71,80.5,-84.68", "--resolution", "5", "--export",
                                folder / "amundsen_5m.tif"});
  ASSERT_EQ(exported.exit_code, 0) << exported.err;
  std::string text = read_text(plan);
  const std::string name = ">LunarSouthPole<";
  text.replace(text.find(name), name.size(), ">amundsen_5m.tif<");
  const Outcome check = run({"check", "--json", folder.write("plan.kml", text)});
  ASSERT_EQ(check.exit_code, 0) << check.out << check.err;
  EXPECT_EQ(nlohmann::json::parse(check.out)["planned_paths"].size(), 7u);
}

}  // namespace
}  // namespace lsos::test
