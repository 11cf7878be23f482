// Seeded legs among craters, driven as planned and driven straight: what planning is for.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <random>

#include "base/units.h"
#include "system/plan_run.h"

namespace lsos::test {
namespace {

struct Series {
  const char *rover, *terrain;
  double length_m;
  int legs;
};

struct Leg {
  std::uint64_t seed;
  std::string from, to;
};

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

Leg leg_of(const Series& series, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const bool is_polar = std::string(series.terrain) == "LunarSouthPole";
  const double lat_deg = is_polar ? uniform(random, -89.5, -85) : 10;
  const double lon_deg = is_polar ? uniform(random, -180, 180) : 20;
  const double azimuth_rad = uniform(random, 0, 2 * std::numbers::pi);
  const double by_deg = degrees(series.length_m / 1737400);
  return {seed, fmt::format("{:.9f},{:.9f}", lon_deg, lat_deg),
          fmt::format("{:.9f},{:.9f}",
                      lon_deg + by_deg * std::sin(azimuth_rad) / std::cos(radians(lat_deg)),
                      lat_deg + by_deg * std::cos(azimuth_rad))};
}

std::vector<Mark> plan_of(const Series& series, const Leg& leg, const char* event_type) {
  return {{"MissionInfo",
           {{"Planet", "Moon"},
            {"StartTime", "2026-01-01T00:00:00Z"},
            {"Terrain", series.terrain},
            {"Seed", std::to_string(leg.seed)},
            {"LogInterval", "60"}},
           ""},
          {"Rover", {{"RoverId", "R"}, {"RoverType", series.rover}}, point(leg.from)},
          event(event_type, "R", 1, {}, line(leg.from + " " + leg.to))};
}

// Whether there is a way that is not the straight one.
bool is_detour(const Series& series, const Leg& leg) {
  const TempFolder folder;
  const Outcome check = run(
      {"check", "--json", folder.write("plan.kml", kml(plan_of(series, leg, "PathPlanRoute")))});
  if (check.exit_code != 0) return false;
  return nlohmann::json::parse(check.out)["planned_paths"][0]["length_m"] > 1.003 * series.length_m;
}

struct Driven {
  bool is_completed = false;
  double distance_m = 0, energy_wh = 0;
  std::string reason;
  std::size_t notes = 0;  // of being stuck or astray
};

Driven driven(const Series& series, const Leg& leg, const char* event_type) {
  const PlanRun run(plan_of(series, leg, event_type));
  const SampleRow last = run.samples().back();
  const auto result = run.summary()["events"][0];
  return {run.outcome.exit_code == 0, last.distance_m, last.drive_j / 3600,
          result["reason"].is_string() ? result["reason"].get<std::string>() : "",
          run.log().notes().size()};
}

class Dodge : public testing::TestWithParam<Series> {};

TEST_P(Dodge, planned_ways_arrive_where_straight_ones_fail_or_cost_more) {
  const Series& series = GetParam();
  int legs = 0, worse = 0;
  std::string table;
  for (std::uint64_t seed = 1; legs < series.legs && seed < 400; ++seed) {
    const Leg leg = leg_of(series, seed);
    if (!is_detour(series, leg)) continue;
    ++legs;
    const Driven planned = driven(series, leg, "PathPlanRoute");
    const Driven straight = driven(series, leg, "Route");
    EXPECT_TRUE(planned.is_completed) << "seed " << seed << ": " << planned.reason;
    EXPECT_EQ(planned.notes, 0u) << "seed " << seed;
    worse += !straight.is_completed || straight.energy_wh > planned.energy_wh;
    table +=
        fmt::format("{} {} {:3}: planned {:6.1f} m {:7.2f} Wh; straight {:6.1f} m {:7.2f} Wh {}\n",
                    series.rover, series.terrain, seed, planned.distance_m, planned.energy_wh,
                    straight.distance_m, straight.energy_wh, straight.reason);
  }
  fmt::print("{}straight is worse in {} of {}\n", table, worse, legs);
  ASSERT_EQ(legs, series.legs);
  EXPECT_GE(2 * worse, legs + 1) << "the straight way mostly fails or costs more";
}

INSTANTIATE_TEST_SUITE_P(
    Legs, Dodge,
    testing::Values(Series{"SEV", "LunarSouthPole", 100, 8}, Series{"SEV", "Craters", 100, 7},
                    Series{"MER", "LunarSouthPole", 30, 8}, Series{"MER", "Craters", 40, 7}),
    [](const auto& tested) { return std::string(tested.param.rover) + tested.param.terrain; });

}  // namespace
}  // namespace lsos::test
