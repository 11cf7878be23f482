// OnFailure of a Rover and of the mission, for events that have none.
#include <gmock/gmock.h>

#include "plan_fixture.h"

namespace lsos {
namespace {

using test::mission;
using test::pause;
using test::rover;
using ::testing::HasSubstr;

Plan plan_without_faults(const std::string& placemarks) {
  Faults faults;
  const Plan plan =
      read_plan(test::write_file(test::document(placemarks)), test::declarations(), faults);
  EXPECT_EQ(test::faults_text(faults), "");
  return plan;
}

TEST(FailureDefault, of_event_rover_and_mission_come_in_that_order) {
  const Plan plan = plan_without_faults(
      mission({{"OnFailure", "skip"}}) + rover("A", {{"OnFailure", "abort"}}) + rover("B") +
      pause("a", "A", 1, {{"OnFailure", "stop"}}) + pause("b", "A", 2) + pause("c", "B", 1));
  EXPECT_EQ(plan.events.at(0).on_failure, OnFailure::stop);
  EXPECT_EQ(plan.events.at(1).on_failure, OnFailure::abort);
  EXPECT_EQ(plan.events.at(2).on_failure, OnFailure::skip);
  EXPECT_THAT(plan.defaults, ::testing::Contains("Rover 'A': OnFailure = abort (1 of 3 events)"));
  EXPECT_THAT(plan.defaults, ::testing::Contains("MissionInfo: OnFailure = skip (1 of 3 events)"));
  EXPECT_THAT(plan.defaults, ::testing::Not(::testing::Contains(HasSubstr("OnFailure = stop"))));
}

// Each rover goes to its own next event of that name, and stops where none follows: none goes
// round.
TEST(FailureDefault, of_a_mission_goes_to_each_rovers_next_event_so_called) {
  const Plan plan = plan_without_faults(
      mission({{"OnFailure", "goto Home"}}) + rover("A") + rover("B") + rover("C") +
      pause("leg", "A", 1) + pause("Home", "A", 2) + pause("leg", "A", 3) + pause("Home", "A", 4) +
      pause("rest", "A", 5) + pause("leg", "B", 7) + pause("Home", "B", 9) + pause("leg", "C", 1));
  const std::vector<std::int64_t> to{2, 4, 4, 0, 0, 9, 0, 0};
  for (std::size_t i = 0; i < to.size(); ++i) {
    const PlanEvent& event = plan.events.at(i);
    EXPECT_EQ(event.on_failure, to[i] == 0 ? OnFailure::stop : OnFailure::go_to) << i;
    EXPECT_EQ(event.go_to_sequence, to[i]) << i;
  }
  EXPECT_THAT(plan.defaults,
              ::testing::Contains("MissionInfo: OnFailure = goto Home (4 of 8 events)"));
  EXPECT_THAT(plan.defaults, ::testing::Contains("OnFailure = stop (4 of 8 events)"));
}

}  // namespace
}  // namespace lsos
