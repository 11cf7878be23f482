// Lines of sight in a mission: layers `pairs` and `sight_intervals`.
#include <gmock/gmock.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>

#include "system/plan_run.h"

namespace lsos::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A distance along the Moon's equator in degrees of longitude.
double degrees_of_m(double distance_m) { return distance_m / 1737400 * 180 / std::numbers::pi; }

std::string east_m(double distance_m) { return fmt::format("{:.9f},0", degrees_of_m(distance_m)); }

Mark flat(const Fields& more = {}) {
  Fields fields{{"Planet", "Moon"}, {"StartTime", "2026-07-01T00:00:00Z"}, {"Terrain", "Flat"}};
  fields.insert(fields.end(), more.begin(), more.end());
  return {"MissionInfo", fields, ""};
}
Mark rover(const std::string& id, const std::string& type, double at_m) {
  return {"Rover", {{"RoverId", id}, {"RoverType", type}}, point(east_m(at_m))};
}
Mark asset(const std::string& id, const std::string& type, double at_m, const Fields& more = {}) {
  Fields fields{{"AssetId", id}, {"AssetType", type}};
  fields.insert(fields.end(), more.begin(), more.end());
  return {"Asset", fields, point(east_m(at_m))};
}

PairRow pair_at(const PlanRun& run, double time_s, const std::string& from, const std::string& to) {
  for (const PairRow& row : run.log().pairs()) {
    if (row.time == from_seconds(time_s) && row.from_id == from && row.to_id == to) return row;
  }
  ADD_FAILURE() << "no row of " << from << " and " << to << " at " << time_s;
  return {};
}

// What the intervals of that kind of a pair say, in order of time.
std::vector<std::string> by(const PlanRun& run, const std::string& from, const std::string& to,
                            const std::string& kind) {
  std::vector<std::string> found;
  for (const SightIntervalRow& row : run.log().sight_intervals()) {
    if (row.from_id == from && row.to_id == to && row.kind == kind) found.push_back(row.by);
  }
  return found;
}

// On a sphere, points at heights h1 and h2 see each other up to sqrt(2 R h1) + sqrt(2 R h2).
TEST(Pairs, ends_at_the_horizon) {
  const double reach_m = std::sqrt(2 * 1737400.0) * (std::sqrt(10.0) + std::sqrt(4.0));
  for (const double share : {0.98, 1.02}) {
    const PlanRun run({flat(), rover("R", "MER", -200),
                       event("Pause", "R", 1, {{"Duration", "60"}}), asset("M1", "CommStation", 0),
                       asset("M2", "CommStation", share * reach_m, {{"Height", "4"}})});
    ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
    const PairRow row = pair_at(run, 60, "M1", "M2");
    EXPECT_EQ(row.visible, share < 1) << share;
    EXPECT_EQ(row.link, share < 1) << share;
    EXPECT_EQ(by(run, "M1", "M2", "hidden"),
              share < 1 ? std::vector<std::string>{} : std::vector<std::string>{"ground"});
    EXPECT_NEAR(row.distance_m, share * reach_m, 1);
  }
}

TEST(Pairs, two_below_each_others_horizon_are_joined_through_an_asset) {
  const PlanRun run({flat(), rover("A", "SEV", 0), rover("B", "SEV", 9000),
                     event("Pause", "A", 1, {{"Duration", "120"}}),
                     asset("Mid", "CommStation", 4500), asset("Off", "CommStation", 60000)});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  const PairRow both = pair_at(run, 0, "A", "B");
  EXPECT_EQ(both.visible, 0);
  EXPECT_EQ(both.link, 0);
  EXPECT_EQ(both.relay, "Mid");
  EXPECT_NEAR(both.distance_m, 9000, 1);
  EXPECT_EQ(pair_at(run, 0, "A", "Mid").link, 1);
  EXPECT_EQ(pair_at(run, 0, "A", "Mid").relay, "");
  EXPECT_EQ(pair_at(run, 0, "A", "Off").relay, "");  // seen by nothing
  // The rovers' own antennas do not reach Earth; the station's does.
  EXPECT_EQ(pair_at(run, 0, "A", "Earth").visible, 1);
  EXPECT_EQ(pair_at(run, 0, "A", "Earth").link, 0);
  EXPECT_EQ(pair_at(run, 0, "A", "Earth").relay, "Mid");
  EXPECT_THAT(by(run, "A", "B", "relayed"), ElementsAre("Mid"));
  EXPECT_THAT(by(run, "A", "Earth", "relayed"), ElementsAre("Mid"));
  EXPECT_THAT(by(run, "A", "Mid", "relayed"), ElementsAre());
  EXPECT_THAT(by(run, "A", "Off", "relayed"), ElementsAre());
  EXPECT_THAT(by(run, "A", "Off", "hidden"), ElementsAre("ground"));
}

// Both stand so high that they see each other; the antennas reach 30 km.
TEST(Pairs, has_no_link_beyond_the_range_of_its_antennas) {
  for (const double away_m : {29.9e3, 30.1e3}) {
    const PlanRun run({flat(), rover("R", "MER", -200),
                       event("Pause", "R", 1, {{"Duration", "60"}}),
                       asset("M1", "CommStation", 0, {{"Height", "400"}}),
                       asset("M2", "CommStation", away_m, {{"Height", "400"}})});
    ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
    const PairRow row = pair_at(run, 60, "M1", "M2");
    EXPECT_EQ(row.visible, 1);
    EXPECT_EQ(row.link, away_m < 30e3) << away_m;
  }
}

// Earth stands 1.1 degrees high in the west; a tall rover drives to a place 40 m away in front of
// it.
TEST(Pairs, of_earth_ends_when_another_rover_stands_before_it) {
  const double azimuth_rad = 274.406 * std::numbers::pi / 180;
  const auto at = [&](double ahead_m, double aside_m) {
    const double east_m = ahead_m * std::sin(azimuth_rad) + aside_m * std::cos(azimuth_rad);
    const double north_m = ahead_m * std::cos(azimuth_rad) - aside_m * std::sin(azimuth_rad);
    return fmt::format("{:.9f},{:.9f}", 86 + degrees_of_m(east_m), degrees_of_m(north_m));
  };
  Mark small{"Rover", {{"RoverId", "A"}, {"RoverType", "MER"}}, point("86,0")};
  Mark tall{"Rover", {{"RoverId", "B"}, {"RoverType", "SEV"}}, point(at(40, 25))};
  const PlanRun run({flat(), small, tall, event("Pause", "A", 1, {{"Duration", "100"}}),
                     event("Route", "B", 1, {{"ArrivalRadius", "0.5"}}, point(at(40, 0)))});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  EXPECT_EQ(pair_at(run, 0, "A", "Earth").visible, 1);
  EXPECT_EQ(pair_at(run, 100, "A", "Earth").visible, 0);
  EXPECT_THAT(by(run, "A", "Earth", "hidden"), ElementsAre("B"));
}

TEST(Pairs, has_each_pair_once_at_each_sample) {
  const PlanRun run({flat(), rover("A", "MER", 0), rover("B", "MER", 50),
                     event("Pause", "A", 1, {{"Duration", "60"}}), asset("M", "CommStation", 100)});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  std::set<std::string> keys;
  const std::vector<PairRow> rows = run.log().pairs();
  for (const PairRow& row : rows) {
    EXPECT_LT(row.from_id, row.to_id == "Earth" ? "~" : row.to_id);
    keys.insert(fmt::format("{} {} {}", seconds(row.time), row.from_id, row.to_id));
  }
  EXPECT_EQ(keys.size(), rows.size());
  EXPECT_EQ(rows.size() % 6, 0u);  // 3 of A, 2 of B, 1 of M at each time
}

TEST(Pairs, a_habitat_stands_between) {
  for (const double aside_deg : {0.0, degrees_of_m(30)}) {
    Mark home = asset("Home", "Habitat", 60);
    home.geometry = point(fmt::format("{:.9f},{:.9f}", degrees_of_m(60), aside_deg));
    const PlanRun run({flat(), rover("A", "MER", 0), rover("B", "MER", 120), home,
                       event("Pause", "A", 1, {{"Duration", "60"}})});
    ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
    EXPECT_EQ(pair_at(run, 0, "A", "B").visible, aside_deg > 0);
    EXPECT_EQ(by(run, "A", "B", "hidden"),
              aside_deg > 0 ? std::vector<std::string>{} : std::vector<std::string>{"Home"});
  }
}

// The Sun stands 13 degrees high in the east. The panel of an array beside the line, which is wider
// than its mast, crosses the line; farther aside it does not.
TEST(Pairs, a_solar_arrays_panel_stands_between) {
  for (const double aside_m : {1.5, 6.0}) {
    Mark array = asset("Array", "SolarArray", 60);
    array.geometry = point(fmt::format("{:.9f},{:.9f}", degrees_of_m(60), degrees_of_m(aside_m)));
    Mark mission = flat();
    mission.fields[1] = {"StartTime", "2026-07-23T00:00:00Z"};
    const PlanRun run({mission, rover("R", "MER", -200),
                       event("Pause", "R", 1, {{"Duration", "60"}}),
                       asset("M1", "CommStation", 0, {{"Height", "4"}}), array,
                       asset("M2", "CommStation", 120, {{"Height", "4"}})});
    ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
    EXPECT_EQ(pair_at(run, 60, "M1", "M2").visible, aside_m > 3) << aside_m;
  }
}

// A second command to a rising mast takes only the remaining time.
TEST(Pairs, a_mast_told_twice_is_up_when_it_is_up) {
  const PlanRun run(
      {flat(), rover("A", "SEV", 0),
       event("DeployCA", "A", 1, {{"Duration", "300"}, {"Timeout", "100"}, {"OnFailure", "skip"}}),
       event("DeployCA", "A", 2)});
  EXPECT_EQ(run.outcome.exit_code, 1) << run.outcome.err;  // the first timed out
  const std::vector<EventRow> events = run.log().events();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[1].status, EventStatus::completed);
  EXPECT_NEAR(seconds(*events[1].end), 300, 0.3);
}

TEST(Pairs, of_earth_ends_where_the_near_side_ends) {
  const auto seen = [](const std::string& at) {
    Mark rover{"Rover", {{"RoverId", "R"}, {"RoverType", "MER"}}, point(at)};
    const PlanRun run({flat(), rover, event("Pause", "R", 1, {{"Duration", "60"}})});
    EXPECT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
    return pair_at(run, 0, "R", "Earth");
  };
  const PairRow near = seen("0,0"), far = seen("180,0");
  EXPECT_EQ(near.visible, 1);
  EXPECT_EQ(near.visible_fraction, 1);
  EXPECT_EQ(near.link, 1);
  EXPECT_NEAR(near.distance_m, 3.84e8, 3e7);
  EXPECT_EQ(far.visible, 0);
  EXPECT_EQ(far.visible_fraction, 0);
  EXPECT_EQ(far.link, 0);
}

TEST(Pairs, a_mast_links_while_it_is_up_and_takes_power) {
  const PlanRun run({flat({{"LogInterval", "1"}, {"ParkedLogInterval", "1"}}), rover("A", "SEV", 0),
                     event("DeployCA", "A", 1, {{"Asset", "Mast"}, {"Duration", "100"}}),
                     event("Pause", "A", 2, {{"Duration", "50"}}),
                     event("StowCA", "A", 3, {{"Duration", "30"}})});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  std::vector<SightIntervalRow> links;
  for (const SightIntervalRow& row : run.log().sight_intervals()) {
    if (row.kind == "link") links.push_back(row);
  }
  ASSERT_EQ(links.size(), 1u);
  EXPECT_EQ(links[0].to_id, "Earth");
  EXPECT_NEAR(seconds(links[0].start), 100, 0.2);
  EXPECT_NEAR(seconds(links[0].end), 150, 0.5);
  EXPECT_NEAR(links[0].light_time_s, 1.28, 0.1);
  const std::vector<SampleRow> rows = run.samples();
  const double before_w = rows[170].load_w - 150;  // while it is lowered
  EXPECT_NEAR(rows[50].load_w, before_w + 150, 1e-9);
  EXPECT_NEAR(rows[120].load_w, before_w + 60, 1e-9);
  EXPECT_EQ(run.log().phases()[0].phase, "start");
}

TEST(Pairs, is_looked_at_whatever_is_logged) {
  const auto intervals = [](const Fields& more, const Words& options) {
    Mark mission = flat(more);
    mission.fields[2] = {"Terrain", "Craters"};
    const PlanRun run({mission, rover("A", "SEV", 0), rover("B", "LRV", 300),
                       event("Route", "A", 1, {}, point(east_m(150))),
                       event("Pause", "B", 1, {{"Duration", "200"}})},
                      options);
    EXPECT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
    std::string text;
    for (const SightIntervalRow& row : run.log().sight_intervals()) {
      text += fmt::format("{} {} {} {} {} {}\n", row.from_id, row.to_id, row.kind,
                          seconds(row.start), seconds(row.end), row.light_time_s);
    }
    return text;
  };
  const std::string once = intervals({{"LogInterval", "2"}}, {});
  EXPECT_THAT(once, HasSubstr("A B visible"));
  EXPECT_EQ(once, intervals({{"LogInterval", "10"}}, {"--threads", "2"}));
  EXPECT_EQ(once, intervals({{"LogInterval", "2"}}, {"--save-every-exchange"}));
}

}  // namespace
}  // namespace lsos::test
