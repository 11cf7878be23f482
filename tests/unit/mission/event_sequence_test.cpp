// The order of events: turns, conditions, failures, timeouts.
#include <gmock/gmock.h>

#include "test_mission.h"

namespace lsos {
namespace {

using test::milliseconds;
using test::Mission;
using test::MockHost;
using testing::HasSubstr;

TEST(EventSequence, an_event_that_goes_round_without_time_passing_fails) {
  Mission mission;
  mission.rover("A");
  mission.event("Spin");
  const EventRow event = mission.run()[0];
  EXPECT_EQ(event.status, EventStatus::failed);
  EXPECT_EQ(event.reason,
            "events/Spin.lua:7: its phases go round without time passing, now in 'a' of Spin");
}

TEST(EventSequence, a_failed_event_stops_its_rover_but_not_the_other) {
  Mission mission;
  mission.rover("A");
  mission.event("Break", 1);
  mission.event("Hold", 1);
  mission.rover("B");
  mission.event("Hold", 5);
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::failed);
  EXPECT_EQ(events[0].reason, "it broke");
  EXPECT_EQ(events[1].status, EventStatus::not_started);
  EXPECT_EQ(events[2].status, EventStatus::completed);
}

TEST(EventSequence, on_failure_skips_aborts_and_goes_to_a_later_event) {
  Mission skip;
  skip.rover("A");
  skip.event("Break", 1).on_failure = OnFailure::skip;
  skip.event("Hold", 1);
  EXPECT_EQ(skip.run()[1].status, EventStatus::completed);

  Mission go_to;
  go_to.rover("A");
  PlanEvent& broken = go_to.event("Break", 1);
  broken.on_failure = OnFailure::go_to;
  broken.go_to_sequence = 3;
  go_to.event("Hold", 1);
  go_to.event("Hold", 1);
  const std::vector<EventRow> events = go_to.run();
  EXPECT_EQ(events[1].status, EventStatus::skipped);
  EXPECT_THAT(events[1].reason, HasSubstr("goes to 'Hold 3'"));
  EXPECT_EQ(events[2].status, EventStatus::completed);

  Mission abort;
  abort.rover("A");
  abort.event("Break", 1).on_failure = OnFailure::abort;
  abort.rover("B");
  abort.event("Hold", 100);
  abort.event("Hold", 100);
  const std::vector<EventRow> aborted = abort.run();
  EXPECT_EQ(aborted[1].status, EventStatus::incomplete);
  EXPECT_EQ(aborted[2].status, EventStatus::not_started);
  EXPECT_TRUE(aborted[2].is_prevented);
}

TEST(EventSequence, a_timeout_fails_the_event_and_lets_its_script_clean_up) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 100).timeout = milliseconds(10000);
  MockHost::aborts = 0;
  const EventRow event = mission.run()[0];
  EXPECT_EQ(event.status, EventStatus::failed);
  EXPECT_EQ(event.end, milliseconds(10000));
  EXPECT_THAT(event.reason, HasSubstr("timed out after 10 s"));
  EXPECT_EQ(MockHost::aborts, 1);
}

TEST(EventSequence, waits_for_the_events_of_another_rover_until_the_next_exchange) {
  // The result is the same in either order of ids.
  for (const bool first : {true, false}) {
    Mission mission;
    mission.rover("A");
    mission.event("Hold", first ? 5 : 1).start_after = {};
    mission.rover("B");
    mission.event("Hold", first ? 1 : 5);
    mission.setup_.plan.events[first ? 1 : 0].start_after = {first ? PlanEvent::Reference{"A", 1}
                                                                   : PlanEvent::Reference{"B", 2}};
    const std::vector<EventRow> events = mission.run();
    EXPECT_EQ(events[first ? 1 : 0].start, milliseconds(5100));
    EXPECT_EQ(events[first ? 1 : 0].ready, milliseconds(0));
  }
}

TEST(EventSequence, an_event_fails_when_what_it_waits_for_can_no_longer_run) {
  Mission mission;
  mission.rover("A");
  mission.event("Break", 1);
  mission.event("Hold", 1);
  mission.rover("B");
  mission.event("Hold", 1).start_after = {{"A", 2}};
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[2].status, EventStatus::failed);
  EXPECT_THAT(events[2].reason, HasSubstr("A/2"));
}

TEST(EventSequence, starts_an_event_not_before_its_time) {
  Mission mission;
  mission.rover("A");
  PlanEvent& event = mission.event("Hold", 1);
  event.start_time = mission.setup_.plan.mission.start_time + milliseconds(60000);
  const EventRow row = mission.run()[0];
  EXPECT_EQ(row.start, milliseconds(60000));
  EXPECT_EQ(row.end, milliseconds(61000));
}

TEST(EventSequence, a_disabled_event_is_passed_over_and_counts_as_ended) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 100).is_enabled = false;
  mission.event("Hold", 1);
  mission.rover("B");
  mission.event("Hold", 1).start_after = {{"A", 1}};
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::disabled);
  EXPECT_EQ(events[1].end, milliseconds(1000));
  EXPECT_EQ(events[2].start, milliseconds(100));
}

TEST(EventSequence, an_event_that_ends_at_its_timeout_has_not_taken_longer) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 60).timeout = milliseconds(60000);
  EXPECT_EQ(mission.run()[0].status, EventStatus::completed);
}

TEST(EventSequence, brakes_at_the_end_of_an_event_that_left_its_rover_driving) {
  Mission mission;
  mission.rover("A");
  mission.drive(50).type = "Leave";
  mission.event("Hold", 30);
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::completed);
  EXPECT_LT(mission.simulation_->results()[0].distance_m, 5);
}

TEST(EventSequence, finds_at_once_that_one_of_several_awaited_events_can_no_longer_run) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 1000);
  mission.rover("B");
  mission.event("Break", 5);
  mission.event("Hold", 1);
  mission.rover("C");
  mission.event("Hold", 1).start_after = {{"A", 1}, {"B", 3}};
  const EventRow event = mission.run()[3];
  EXPECT_EQ(event.status, EventStatus::failed);
  EXPECT_EQ(event.end, milliseconds(5100));
}

}  // namespace
}  // namespace lsos
