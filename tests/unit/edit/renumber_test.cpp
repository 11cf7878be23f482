// Other sequences, and what refers to them.
#include "edit/renumber.h"

#include "edit_fixture.h"

namespace lsos::test {
namespace {

using ::testing::ElementsAre;

TEST(Renumber, gives_round_numbers_in_order) {
  TestPlan plan(mission() + rover("A") + rover("B") + pause("c", "A", 7) + pause("a", "A", -3) +
                pause("b", "A", 2) + pause("d", "B", 10));
  EXPECT_EQ(renumber(plan.document, 10, ""), 3);
  EXPECT_THAT(listed_events(plan.edited()),
              ElementsAre("A/10 Pause 'a'", "A/20 Pause 'b'", "A/30 Pause 'c'", "B/10 Pause 'd'"));
}

TEST(Renumber, is_of_one_rover_and_with_another_step) {
  TestPlan plan(mission() + rover("A") + rover("B") + pause("a", "A", 3) + pause("b", "B", 3) +
                pause("c", "B", 4));
  EXPECT_EQ(renumber(plan.document, 5, "B"), 2);
  EXPECT_THAT(listed_events(plan.edited()),
              ElementsAre("A/3 Pause 'a'", "B/5 Pause 'b'", "B/10 Pause 'c'"));
}

// 10 becomes 20 and 20 becomes 30: a reference must follow once.
TEST(Renumber, references_follow_once) {
  const std::string before = mission() + rover("A") + rover("B") + pause("", "A", 5) +
                             pause("", "A", 10) + pause("x, y", "A", 20) +
                             pause("", "B", 1, {{"StartAfter", "A/10, x\\, y, Pause 5"}}) +
                             pause("", "B", 2, {{"StartAfter", "x\\, y"}}) +
                             pause("", "B", 3, {{"OnFailure", "goto B/8"}}) + pause("", "B", 8);
  TestPlan plan(before);
  const Plan edited = (renumber(plan.document, 10, ""), plan.edited());
  EXPECT_EQ(plan.document.field(plan.document.mark(plan.event("B", 1)), "StartAfter"),
            "A/20, x\\, y, A/10");
  EXPECT_EQ(plan.document.field(plan.document.mark(plan.event("B", 2)), "StartAfter"), "x\\, y");
  EXPECT_EQ(plan.document.field(plan.document.mark(plan.event("B", 3)), "OnFailure"), "goto B/40");
  const PlanEvent& waiting = edited.events[3];
  EXPECT_THAT(waiting.start_after,
              ElementsAre(PlanEvent::Reference{"A", 10}, PlanEvent::Reference{"A", 20},
                          PlanEvent::Reference{"A", 30}));
}

// The default label has the sequence in it.
TEST(Renumber, keeps_labels_that_a_rover_or_the_mission_goes_to) {
  TestPlan plan(mission({{"OnFailure", "goto Pause 8"}}) + rover("A", {{"OnFailure", "goto A/9"}}) +
                rover("B") + pause("", "A", 1) + pause("", "A", 9) + pause("", "B", 1) +
                pause("", "B", 8));
  renumber(plan.document, 10, "");
  const Plan edited = plan.edited();
  EXPECT_EQ(edited.rovers[0].on_failure.text, "goto A/20");
  EXPECT_EQ(edited.mission.on_failure.text, "goto Pause 8");
  EXPECT_THAT(listed_events(edited), ElementsAre("A/10 Pause 'Pause 10'", "A/20 Pause 'Pause 20'",
                                                 "B/10 Pause 'Pause 10'", "B/20 Pause 'Pause 8'"));
  EXPECT_EQ(edited.events[0].go_to_sequence, 20);
  EXPECT_EQ(edited.events[2].go_to_sequence, 20);
}

TEST(Renumber, changes_nothing_of_a_plan_in_order) {
  TestPlan plan(mission() + rover("A") + pause("a", "A", 10) + pause("b", "A", 20));
  EXPECT_EQ(renumber(plan.document, 10, ""), 0);
  EXPECT_EQ(plan.document.text(), plan.text);
}

}  // namespace
}  // namespace lsos::test
