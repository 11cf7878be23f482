// A rover's energy over a mission without light: the stored energy follows from the flows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "test_mission.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

BatterySpec battery(double capacity_j) {
  BatterySpec battery;
  battery.capacity_j = capacity_j;
  battery.discharge_efficiency = 0.8;
  battery.reserve = 0.2;
  return battery;
}

class Energy : public ::testing::Test {
 protected:
  Energy() {
    mission.rover("A");
    power().battery = battery(1e6);
    power().loads = {{"housekeeping", 100, LoadState::always}};
  }
  PowerSpec& power() { return mission.setup_.rover_models["Test"].power; }
  RoverResult result() const { return mission.simulation_->results().front(); }

  Mission mission;
};

TEST_F(Energy, of_a_parked_rover_falls_as_its_loads_say) {
  mission.event("Hold", 3600);
  const auto events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::completed);
  // 100 W at the bus for an hour, with the discharge loss.
  EXPECT_NEAR(result().energy_start_j - result().energy_end_j, 100 * 3600 / 0.8, 1e-6);
  EXPECT_NEAR(result().energy_used_j, 100 * 3600 / 0.8, 1e-6);
  EXPECT_NEAR(events[0].energy_used_j, 100 * 3600 / 0.8, 1e-6);
  EXPECT_LT(mission.exchanges, 20);  // the clock leapt
}

TEST_F(Energy, of_work_is_added_while_its_event_runs) {
  PlanEvent& work = mission.event("Work", 600);
  work.params["power_w"] = 400.0;
  mission.event("Hold", 600);
  const auto events = mission.run();
  EXPECT_NEAR(events[0].energy_used_j, 500 * 600 / 0.8, 1e-6);
  EXPECT_NEAR(events[1].energy_used_j, 100 * 600 / 0.8, 1e-6);
}

TEST_F(Energy, of_a_drive_is_what_its_motors_took) {
  power().loads.clear();
  mission.drive(20);
  const auto events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::completed);
  EXPECT_GT(result().energy_used_j, 100);
  EXPECT_NEAR(result().energy_start_j - result().energy_end_j, result().energy_used_j, 1e-6);
}

// The first period of a drive after a long stand lasts one period, not as long as the stand.
TEST_F(Energy, of_a_drive_after_a_stand_is_no_other) {
  power().loads.clear();
  mission.drive(20);
  mission.run();
  const double at_once_j = result().energy_used_j;
  Mission again;
  again.rover("A");
  again.setup_.rover_models["Test"].power = power();
  again.event("Hold", 3600.1);
  again.drive(20);
  again.run();
  EXPECT_NEAR(again.simulation_->results()[0].energy_used_j, at_once_j, 1e-3 * at_once_j);
}

// Energy is counted to the last exchange before MaxDuration, though nothing happens there.
TEST_F(Energy, at_the_end_of_time_is_of_that_time) {
  mission.event("Hold", 1e6);
  mission.setup_.plan.mission.max_duration = SimTime{1'000'000'000};
  mission.run();
  EXPECT_NEAR(result().energy_used_j, 100 * 1000 / 0.8, 1e-6);
}

TEST_F(Energy, that_was_never_there_fails_work_at_once) {
  mission.setup_.plan.rovers[0].initial_charge = 0;
  mission.event("Work", 3600).params["power_w"] = 10.0;
  const auto events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::failed);
  EXPECT_LE(seconds(*events[0].end), 0.1);
}

TEST_F(Energy, counts_from_the_plans_initial_charge) {
  mission.setup_.plan.rovers[0].initial_charge = 0.25;
  mission.event("Hold", 1);
  mission.run();
  EXPECT_DOUBLE_EQ(result().energy_start_j, 0.25e6);
}

// 1e6 J x 0.8 / 100 W = 8000 s.
TEST_F(Energy, that_is_used_up_lets_waiting_go_on) {
  mission.event("Hold", 20000);
  const auto events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::completed);
  EXPECT_EQ(result().energy_end_j, 0);
  EXPECT_NEAR(result().energy_used_j, 1e6, 1e-6);
}

TEST_F(Energy, that_is_used_up_ends_work_then_and_there) {
  mission.event("Work", 20000).params["power_w"] = 0.0;
  const auto events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::failed);
  EXPECT_EQ(events[0].reason, "the battery is empty");
  EXPECT_NEAR(seconds(*events[0].end), 8000, 0.2);
}

TEST_F(Energy, that_is_used_up_stops_a_drive) {
  power().battery = battery(3e4);
  power().battery->reserve = 0;
  power().loads = {{"lamp", 500, LoadState::driving}};
  mission.drive(200);
  const auto events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::failed);
  EXPECT_EQ(events[0].reason, "the battery is empty");
  EXPECT_LT(mission.simulation_->results()[0].distance_m, 150);
  EXPECT_GT(mission.simulation_->results()[0].distance_m, 5);
}

// The drive ends at the exchange at which 80 % are used, so it uses less than two exchanges' energy
// more than that.
TEST_F(Energy, down_to_the_reserve_stops_a_drive_but_no_work) {
  power().battery = battery(3e4);
  power().loads = {{"lamp", 500, LoadState::driving}};
  PlanEvent& drive = mission.drive(200);
  drive.on_failure = OnFailure::skip;
  mission.event("Work", 10).params["power_w"] = 20.0;
  const auto events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::failed);
  EXPECT_EQ(events[0].reason,
            "its charge is below the reserve of 20 %, which is kept for its loads");
  EXPECT_GT(events[0].energy_used_j, 0.8 * 3e4);
  const double duration_s = seconds(*events[0].end - *events[0].start);
  const double of_an_exchange_j = events[0].energy_used_j / duration_s * seconds(exchange_period);
  EXPECT_LT(events[0].energy_used_j, 0.8 * 3e4 + 2 * of_an_exchange_j);
  EXPECT_EQ(events[1].status, EventStatus::completed) << events[1].reason;
  EXPECT_THAT(mission.simulation_->warnings(),
              ::testing::Contains(HasSubstr("below the reserve of 20 %; it does not drive before "
                                            "it is above 25 %")));
}

// From 10 % to 25 % of 1e6 J by 200 W less 100 W: 1500 s. Work below the reserve goes on.
TEST_F(Energy, well_above_the_reserve_is_wanted_to_drive) {
  mission.setup_.plan.rovers[0].initial_charge = 0.1;
  power().generator_w = 200;
  mission.event("Work", 100).params["power_w"] = 0.0;
  mission.drive(5);
  const auto events = mission.run();
  EXPECT_NEAR(seconds(*events[0].end), 100, 0.2);
  EXPECT_EQ(events[1].status, EventStatus::completed) << events[1].reason;
  EXPECT_NEAR(seconds(*events[1].start), 1500, 0.2);
}

TEST_F(Energy, below_the_reserve_fails_a_drive_where_nothing_charges) {
  mission.setup_.plan.rovers[0].initial_charge = 0.1;
  mission.drive(5).on_failure = OnFailure::skip;
  mission.event("Hold", 10);
  const auto events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::failed);
  EXPECT_EQ(events[0].reason,
            "its charge is below the reserve of 20 %, which is kept for its loads, and nothing "
            "charges it: there are no solar panels");
  EXPECT_EQ(events[1].status, EventStatus::completed);
}

// After a failure that is skipped, work waits for the reserve; what needs no power does not.
TEST_F(Energy, above_the_reserve_is_wanted_to_go_on) {
  power().generator_w = 1;  // less than it uses
  PlanEvent& first = mission.event("Work", 20000);
  first.params["power_w"] = 0.0;
  first.on_failure = OnFailure::skip;
  mission.event("Hold", 100);
  mission.event("Work", 10).params["power_w"] = 0.0;
  mission.setup_.plan.mission.max_duration = SimTime{10'000'000'000};
  const auto events = mission.run();
  EXPECT_EQ(events[1].status, EventStatus::completed);
  EXPECT_EQ(events[2].status, EventStatus::not_started);
  EXPECT_THAT(events[2].reason,
              testing::HasSubstr("; it waited for charge above the reserve, as the battery was "
                                 "empty; charge was 0"));
}

TEST_F(Energy, that_nothing_will_bring_is_not_waited_for) {
  PlanEvent& first = mission.event("Work", 20000);
  first.params["power_w"] = 0.0;
  first.on_failure = OnFailure::skip;
  PlanEvent& second = mission.event("Work", 10);
  second.params["power_w"] = 0.0;
  second.on_failure = OnFailure::skip;
  mission.event("Hold", 100);
  const auto events = mission.run();
  EXPECT_EQ(events[1].status, EventStatus::failed);
  EXPECT_EQ(events[1].reason,
            "the battery is empty, and nothing charges it: there are no solar panels");
  EXPECT_NEAR(seconds(*events[1].end), 8000, 0.3);
  EXPECT_EQ(events[2].status, EventStatus::completed) << "it goes on without power";
}

// Without any capacity no charge is ever above the reserve: the rover goes on as soon as its
// generator suffices.
TEST_F(Energy, that_a_battery_without_capacity_does_not_hold_lets_go_on_what_the_generator_feeds) {
  power().generator_w = 150;
  PlanEvent& work = mission.event("Work", 600);
  work.params["power_w"] = 400.0;
  work.on_failure = OnFailure::skip;
  mission.event("Work", 10).params["power_w"] = 20.0;
  mission.setup_.plan.mission.max_duration = std::chrono::hours(1);
  mission.simulation_ = std::make_unique<Simulation>(mission.setup_);
  Simulation& simulation = *mission.simulation_;
  simulation.start();
  simulation.advance(milliseconds(5000));
  simulation.fleet().rovers[0].agent->inject({.what = "battery", .share = 1.0});
  while (!simulation.is_finished()) simulation.advance();
  simulation.terminate();
  const std::vector<EventRow> events = simulation.events();
  EXPECT_EQ(events[0].status, EventStatus::failed);
  EXPECT_EQ(events[1].status, EventStatus::completed) << events[1].reason;
  EXPECT_LT(simulation.now(), milliseconds(60000));
  EXPECT_THAT(simulation.warnings(), ::testing::Contains(HasSubstr("its charge is 0.0 %")));
}

TEST_F(Energy, is_the_same_when_all_state_is_saved_at_each_exchange) {
  const auto end_j = [&](bool is_saving) {
    Mission again;
    again.rover("A");
    PowerSpec& spec = again.setup_.rover_models["Test"].power;
    spec = power();
    spec.resources = {{"oxygen", "kg", 3}};
    again.setup_.save_every_exchange = is_saving;
    again.drive(5);
    again.event("Work", 30).params["power_w"] = 50.0;
    again.run();
    return again.simulation_->results()[0].energy_end_j;
  };
  EXPECT_EQ(end_j(true), end_j(false));
}

}  // namespace
}  // namespace lsos::test
