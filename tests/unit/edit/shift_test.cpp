// Times of a plan, all earlier or later.
#include "edit/shift.h"

#include "edit_fixture.h"

namespace lsos::test {
namespace {

constexpr SimTime hour{3'600'000'000};

std::string timed_plan() {
  return mission() + rover("A") + rover("B") +
         event("Wait", "w", "A", 10, {{"Until", "2026-07-01T06:00Z"}}) +
         pause("p", "A", 20, {{"StartTime", "2026-07-02"}}) +
         event("Fault", "f", "A", 30, {{"At", "2 h"}}) +
         event("Fault", "g", "B", 10, {{"At", "2026-07-01T03:00:00Z"}});
}

std::string value(const TestPlan& plan, const std::string& rover, int sequence, const char* name) {
  return plan.document.field(plan.document.mark(plan.event(rover, sequence)), name);
}

TEST(Shift, moves_the_whole_mission) {
  TestPlan plan(timed_plan());
  EXPECT_EQ(shift_times(plan.document, 24 * hour, {}), 4);
  EXPECT_EQ(plan.document.field(plan.document.mission(), "StartTime"), "2026-07-02T00:00:00Z");
  EXPECT_EQ(value(plan, "A", 10, "Until"), "2026-07-02T06:00Z");
  EXPECT_EQ(value(plan, "A", 20, "StartTime"), "2026-07-03");
  EXPECT_EQ(value(plan, "A", 30, "At"), "2 h") << "from the mission's start";
  EXPECT_EQ(value(plan, "B", 10, "At"), "2026-07-02T03:00:00Z");
  const Plan edited = plan.edited();
  for (std::size_t i = 0; i < edited.events.size(); ++i) {
    EXPECT_EQ(edited.events[i].at, plan.plan.events[i].at);
  }
}

TEST(Shift, moves_a_rover_within_the_mission) {
  TestPlan plan(timed_plan());
  EXPECT_EQ(shift_times(plan.document, hour, {"A", nullptr}), 3);
  EXPECT_EQ(plan.document.field(plan.document.mission(), "StartTime"), "2026-07-01T00:00:00Z");
  EXPECT_EQ(value(plan, "A", 30, "At"), "10800 s");
  EXPECT_EQ(value(plan, "B", 10, "At"), "2026-07-01T03:00:00Z");
  plan.edited();
}

TEST(Shift, moves_what_comes_from_an_event_on) {
  TestPlan plan(timed_plan());
  EXPECT_EQ(shift_times(plan.document, hour, {"", &plan.event("A", 20)}), 2);
  EXPECT_EQ(value(plan, "A", 10, "Until"), "2026-07-01T06:00Z");
  EXPECT_EQ(value(plan, "A", 20, "StartTime"), "2026-07-02T01:00Z");
}

TEST(Shift, there_and_back_is_the_plan_that_it_was) {
  TestPlan plan(timed_plan());
  shift_times(plan.document, 24 * hour, {});
  const std::string there = plan.document.text();
  const Plan moved = plan.edited();
  PlanDocument back(there, moved, plan.known);
  shift_times(back, -24 * hour, {});
  EXPECT_EQ(canonical(back.text()), canonical(plan.text));
}

TEST(Shift, refuses_times_before_the_start) {
  TestPlan plan(timed_plan());
  try {
    shift_times(plan.document, -3 * hour, {"A", nullptr});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                ::testing::HasSubstr("Fault 'f': At = 2 h would be 3600 s before the mission's"));
  }
}

}  // namespace
}  // namespace lsos::test
