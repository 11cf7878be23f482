// Time, rovers and state of a mission.
#include <gmock/gmock.h>

#include <numbers>

#include "test_mission.h"

namespace lsos {
namespace {

using test::milliseconds;
using test::Mission;
using test::MockHost;
using testing::AllOf;
using testing::HasSubstr;

TEST(Simulation, runs_the_events_of_a_rover_one_after_another) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 5);
  mission.event("Hold", 2.05);
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[0].end, milliseconds(5000));
  EXPECT_EQ(events[1].ready, milliseconds(5000));
  // Wakes are rounded up to an exchange.
  EXPECT_EQ(events[1].end, milliseconds(7100));
  EXPECT_EQ(events[1].status, EventStatus::completed);
}

TEST(Simulation, leaps_over_quiet_time) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 14.0 * 86400);
  MockHost::calls = 0;
  mission.run();
  EXPECT_EQ(mission.exchanges, 1);
  EXPECT_EQ(MockHost::calls, 3);
  EXPECT_EQ(mission.simulation_->now(), std::chrono::hours(14 * 24));
}

TEST(Simulation, calls_a_phase_that_stays_at_each_exchange) {
  Mission mission;
  mission.rover("A");
  mission.event("Poll");
  EXPECT_EQ(mission.run()[0].end, milliseconds(200));
}

TEST(Simulation, an_event_may_be_made_of_others) {
  Mission mission;
  mission.rover("A");
  mission.event("Twice");
  EXPECT_EQ(mission.run()[0].end, milliseconds(20000));
}

TEST(Simulation, max_duration_ends_the_run_as_incomplete) {
  Mission mission;
  mission.setup_.plan.mission.max_duration = milliseconds(30000);
  mission.rover("A");
  mission.event("Hold", 100);
  const EventRow event = mission.run()[0];
  EXPECT_EQ(event.status, EventStatus::incomplete);
  EXPECT_EQ(mission.simulation_->now(), milliseconds(30000));
}

TEST(Simulation, that_ends_too_early_says_what_each_event_waited_for) {
  Mission mission;
  mission.setup_.plan.mission.max_duration = milliseconds(30000);
  mission.setup_.plan.mission.has_max_duration = true;
  mission.rover("A");
  mission.event("Hold", 100);
  mission.event("Hold", 1);
  mission.rover("B");
  mission.event("Hold", 1).start_after = {{"A", 1}};
  mission.rover("C");
  mission.event("Hold", 1).start_time = *parse_utc("2026-01-02").value;
  mission.rover("D");
  mission.event("Hold", 1).start_when = {"charge > 1.5", 1};
  mission.rover("E");
  mission.drive(300);
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[0].reason, "MaxDuration is over, in phase 'hold' since 0 s");
  EXPECT_EQ(events[1].reason, "MaxDuration is over; its turn did not come, 'Hold 1' was under way");
  EXPECT_EQ(events[2].reason,
            "MaxDuration is over; it waited for StartAfter: A/1 is still under way");
  EXPECT_EQ(events[3].reason,
            "MaxDuration is over; it waited for StartTime: 2026-01-02T00:00:00.000Z");
  // The mock host knows no quantities.
  EXPECT_EQ(events[4].reason,
            "MaxDuration is over; it waited for StartWhen: charge > 1.5, which did not hold");
  EXPECT_THAT(events[5].reason, testing::MatchesRegex(".*in phase 'arrive' since 0 s; 2[0-9]* m "
                                                      "are left to drive"));
}

TEST(Simulation, drives_a_rover_to_its_point) {
  Mission mission;
  mission.rover("A");
  mission.drive(20);
  const EventRow event = mission.run()[0];
  EXPECT_EQ(event.status, EventStatus::completed) << event.reason;
  EXPECT_NEAR(event.distance_m, 20, 0.5);
  EXPECT_NEAR(mission.simulation_->results()[0].distance_m, 20, 0.5);
}

TEST(Simulation, refuses_a_start_too_steep_to_stand_on) {
  Mission mission;
  mission.setup_.terrain.layers = {PlaneSurface{0, 0.9, 0}};
  mission.rover("A");
  mission.event("Hold", 1);
  try {
    mission.run();
    FAIL() << "the rover stands on 52 degrees";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("does not come to rest there: after 20 s it still moves at "),
                      HasSubstr(" m/s; the plane under its wheels slopes by 52 deg")));
  }
}

// Down a slope of 6 degrees: once a drive, and 2 degrees more than was planned for is no news.
TEST(Simulation, warns_of_a_steeper_slope_than_a_drive_was_planned_for) {
  Mission mission;
  mission.rover("A");
  const double deg = std::numbers::pi / 180;
  mission.setup_.terrain.layers = {PlaneSurface{0, 6 * deg, 90 * deg}};
  mission.drive(3).params["slope_max_rad"] = 3 * deg;
  mission.drive(6).params["slope_max_rad"] = 4.5 * deg;
  mission.run();
  ASSERT_EQ(mission.simulation_->warnings().size(), 1u);
  EXPECT_THAT(mission.simulation_->warnings()[0], HasSubstr("it drives on a slope of 6.0 deg, 3.0 "
                                                            "deg are allowed, at "));
}

TEST(Simulation, warns_of_a_speed_that_the_rover_does_not_reach) {
  Mission mission;
  mission.rover("A");
  mission.drive(5).params["speed_mps"] = 50.0;
  mission.run();
  ASSERT_EQ(mission.simulation_->warnings().size(), 1u);
  EXPECT_THAT(mission.simulation_->warnings()[0], HasSubstr("commanded to drive at 50 m/s"));
}

// Final state, as a fingerprint, of two rovers that drive and wait for each other.
std::string fingerprint(int threads, bool save_every_exchange) {
  Mission mission;
  mission.setup_.threads = threads;
  mission.setup_.save_every_exchange = save_every_exchange;
  mission.rover("A");
  mission.drive(15);
  mission.event("Twice");
  mission.rover("B");
  mission.event("Hold", 1).start_after = {{"A", 1}};
  mission.drive(-12);
  mission.run();
  return mission.simulation_->save();
}

TEST(Simulation, ends_in_the_same_bits_again_on_two_threads_and_in_torture) {
  const std::string once = fingerprint(1, false);
  EXPECT_EQ(fingerprint(1, false), once);
  EXPECT_EQ(fingerprint(2, false), once);
  EXPECT_EQ(fingerprint(1, true), once);
}

TEST(Simulation, goes_on_from_saved_state_to_the_same_end) {
  Mission mission;
  mission.rover("A");
  mission.drive(10);
  mission.event("Hold", 5);
  mission.run();
  const std::string end = mission.simulation_->save();

  Simulation first(mission.setup_);
  first.start();
  for (int i = 0; i < 57; ++i) first.advance();
  const std::string middle = first.save();
  Simulation second(mission.setup_);
  second.restore(middle);
  while (!second.is_finished()) second.advance();
  second.terminate();
  EXPECT_EQ(second.save(), end);
}

}  // namespace
}  // namespace lsos
