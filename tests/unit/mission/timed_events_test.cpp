// Events that take effect at a time of their own, beside the event whose turn it is.
#include <gmock/gmock.h>

#include "test_mission.h"

namespace lsos {
namespace {

using test::milliseconds;
using test::Mission;
using testing::HasSubstr;

// An event that ends at once; Hold without a duration does.
PlanEvent& timed(Mission& mission, std::int64_t at_ms, const std::string& type = "Hold") {
  PlanEvent& event = mission.event(type);
  event.at = milliseconds(at_ms);
  return event;
}

TEST(TimedEvents, begin_and_end_at_their_exchange_and_hold_up_nothing) {
  Mission mission;
  mission.rover("A");
  timed(mission, 5050);
  mission.event("Hold", 10);
  timed(mission, 2000);
  mission.event("Hold", 10);
  const std::vector<EventRow> events = mission.run();
  for (const EventRow& event : events) EXPECT_EQ(event.status, EventStatus::completed);
  EXPECT_EQ(events[0].ready, milliseconds(5100));
  EXPECT_EQ(events[0].start, milliseconds(5100));
  EXPECT_EQ(events[0].end, milliseconds(5100));
  EXPECT_EQ(events[2].end, milliseconds(2000));
  EXPECT_EQ(events[1].start, SimTime{});
  EXPECT_EQ(events[3].start, milliseconds(10000));
  EXPECT_EQ(events[3].end, milliseconds(20000));
  EXPECT_LT(mission.exchanges, 10);  // the clock leapt
}

TEST(TimedEvents, leave_a_drive_and_its_power_alone) {
  const auto end_of = [](bool is_disturbed) {
    Mission mission;
    mission.rover("A");
    PowerSpec& power = mission.setup_.rover_models["Test"].power;
    power.battery.emplace().capacity_j = 1e6;
    mission.drive(10);
    mission.event("Work", 60).params["power_w"] = 400.0;
    if (is_disturbed) {
      timed(mission, 2000);
      timed(mission, 60000, "Break").on_failure = OnFailure::skip;
    }
    mission.run();
    return mission.simulation_->results()[0].energy_end_j;
  };
  EXPECT_EQ(end_of(true), end_of(false));
}

TEST(TimedEvents, take_effect_on_a_rover_whose_events_are_over) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 1);
  timed(mission, 5000);
  mission.rover("B");
  mission.event("Hold", 10);
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[1].status, EventStatus::completed);
  EXPECT_EQ(events[1].end, milliseconds(5000));
}

TEST(TimedEvents, are_awaited_like_others) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 1).start_after = {{"A", 2}};
  timed(mission, 5000);
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::completed);
  EXPECT_EQ(events[0].start, milliseconds(5100));
}

TEST(TimedEvents, that_do_not_end_at_once_fail) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 10);
  timed(mission, 5000, "Poll");
  mission.event("Hold", 10);
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[1].status, EventStatus::failed);
  EXPECT_THAT(events[1].reason, HasSubstr("must end at once; phase 'poll' does not"));
  EXPECT_EQ(events[0].status, EventStatus::incomplete) << "OnFailure is stop";
  EXPECT_EQ(events[0].reason, "'Poll 2' failed");
  EXPECT_EQ(events[2].status, EventStatus::not_started);
}

TEST(TimedEvents, whose_phases_go_round_say_so) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 10);
  timed(mission, 5000, "Spin");
  EXPECT_EQ(mission.run()[1].reason,
            "events/Spin.lua:7: its phases go round without time passing, now in 'a' of Spin");
}

TEST(TimedEvents, have_not_started_when_the_mission_ends_before) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 10);
  timed(mission, 20000);
  EventRow event = mission.run()[1];
  EXPECT_EQ(event.status, EventStatus::not_started);
  EXPECT_EQ(event.reason, "the mission was over at 10 s, before 20 s");

  Mission failed;
  failed.rover("A");
  failed.event("Break", 10);
  timed(failed, 20000);
  EXPECT_TRUE(failed.run()[1].is_prevented);

  Mission went_on;
  went_on.rover("A");
  went_on.event("Break", 10).on_failure = OnFailure::skip;
  timed(went_on, 20000);
  event = went_on.run()[1];
  EXPECT_FALSE(event.is_prevented) << "the failure did not end the events";
  EXPECT_EQ(event.reason, "the mission was over at 10 s, before 20 s");

  Mission stopped;
  stopped.rover("A");
  stopped.event("Hold", 100);
  timed(stopped, 20000);
  stopped.setup_.plan.mission.max_duration = milliseconds(15000);
  event = stopped.run()[1];
  EXPECT_EQ(event.status, EventStatus::not_started);
  EXPECT_THAT(event.reason, HasSubstr("MaxDuration is over"));
}

TEST(TimedEvents, end_in_the_same_bits_in_torture) {
  const auto state = [](bool is_saving) {
    Mission mission;
    mission.setup_.save_every_exchange = is_saving;
    mission.rover("A");
    mission.drive(5);
    timed(mission, 3000, "Twitch");
    mission.event("Hold", 2);
    timed(mission, 1000, "Twitch");
    mission.run();
    return mission.simulation_->save();
  };
  EXPECT_EQ(state(true), state(false));
}

}  // namespace
}  // namespace lsos
