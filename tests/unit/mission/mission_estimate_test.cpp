// An estimate against the simulation of the same mission.
#include "mission/mission_estimate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mission/estimate/estimate_warnings.h"
#include "test_mission.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

class Estimate : public ::testing::Test {
 protected:
  Estimate() {
    mission.rover("A");
    PowerSpec& power = mission.setup_.rover_models["Test"].power;
    power.battery.emplace();
    power.battery->capacity_j = 1e7;
    power.loads = {{"housekeeping", 100, LoadState::always}};
  }
  MissionEstimate estimate() {
    SimulationSetup setup = mission.setup_;
    setup.is_estimate = true;
    Simulation simulation(std::move(setup));
    return estimate_mission(simulation);
  }
  void expect_as_simulated() {
    const std::vector<EventEstimate> expected = estimate().events;
    const std::vector<EventRow> events = mission.run();
    ASSERT_EQ(expected.size(), events.size());
    for (std::size_t k = 0; k < events.size(); ++k) {
      EXPECT_EQ(expected[k].status, events[k].status) << k << expected[k].reason;
      EXPECT_NEAR(*expected[k].end_s, seconds(*events[k].end), 0.03 * seconds(*events[k].end)) << k;
      EXPECT_NEAR(*expected[k].distance_m, events[k].distance_m, 0.5) << k;
      EXPECT_NEAR(*expected[k].energy_used_j, events[k].energy_used_j,
                  0.15 * events[k].energy_used_j)
          << k;
    }
  }
  Mission mission;
};

TEST_F(Estimate, of_drives_and_stops_is_as_simulated) {
  mission.drive(300);
  mission.event("Hold", 1000);
  mission.drive(-100);
  expect_as_simulated();
}

TEST_F(Estimate, of_a_planned_route_is_as_simulated) {
  mission.drive("Plan", 300);
  mission.event("Work", 500).params["power_w"] = 300.0;
  expect_as_simulated();
}

TEST_F(Estimate, of_rovers_that_wait_for_each_other_is_as_simulated) {
  mission.drive(200);
  mission.rover("B");
  mission.event("Hold", 100).start_after = {{"A", 1}};
  expect_as_simulated();
}

TEST_F(Estimate, knows_the_lowest_charge) {
  mission.event("Work", 3600).params["power_w"] = 900.0;
  const EventEstimate event = estimate().events.front();
  EXPECT_NEAR(*event.charge_end, 1 - 1000 * 3600 / 1e7, 1e-9);
  EXPECT_EQ(event.charge_min, event.charge_end);
  EXPECT_FALSE(event.sunlit_share);  // it has no panels
}

TEST_F(Estimate, of_a_drive_ends_where_the_battery_is_empty) {
  mission.setup_.rover_models["Test"].power.battery->capacity_j = 2e4;
  mission.drive(500);
  mission.drive(900);
  const std::vector<EventEstimate> events = estimate().events;
  EXPECT_EQ(events[0].status, EventStatus::failed);
  EXPECT_THAT(events[0].reason, HasSubstr("the battery is empty"));
  EXPECT_GT(*events[0].distance_m, 10);
  EXPECT_LT(*events[0].distance_m, 490);
  EXPECT_FALSE(events[1].end_s);  // it does not start
  const std::vector<Fault> warnings = estimate_warnings(events, mission.setup_.plan, {});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0].what,
              HasSubstr("Drive 'Drive 1': by the estimate it fails at 2026-01-01T"));
  // Told of once.
  EXPECT_TRUE(estimate_warnings(events, mission.setup_.plan, warnings).empty());
}

TEST_F(Estimate, sums_up_days_which_end_between_what_happens) {
  mission.setup_.rover_models["Test"].power.battery->capacity_j = 1e8;
  mission.drive(100);
  mission.event("Hold", 2 * 86400);
  const MissionEstimate whole = estimate();
  ASSERT_EQ(whole.days.size(), 3U);
  EXPECT_EQ(whole.days[2].rover_id, "A");
  EXPECT_EQ(whole.days[2].day, 3);
  double distance_m = 0, used_j = 0;
  for (const DayEstimate& day : whole.days) {
    distance_m += day.distance_m;
    used_j += *day.energy_used_j;
    EXPECT_LE(*day.charge_min, *day.charge_end);
  }
  EXPECT_NEAR(distance_m, *whole.events[0].distance_m, 1e-9);
  EXPECT_NEAR(used_j, *whole.events[0].energy_used_j + *whole.events[1].energy_used_j, 1);
  EXPECT_NEAR(*whole.days[1].energy_used_j, 100 * 86400, 1e-3);  // it stands all day
  EXPECT_NEAR(whole.days[0].distance_m, distance_m, 1e-9);
}

}  // namespace
}  // namespace lsos::test
