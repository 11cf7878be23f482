// What is told of conditions that may hold.
#include "mission/estimate/lack_warnings.h"

#include <gmock/gmock.h>

namespace lsos {
namespace {

using ::testing::HasSubstr;

TEST(DoubtWarnings, tell_of_warn_when_that_may_hold_for_a_part) {
  Plan plan;
  PlanEvent& planned = plan.events.emplace_back();
  planned.rover_id = "A";
  planned.sequence = 10;
  planned.warn_when.text = "not sees('Earth')";
  EventEstimate event;
  event.rover_id = "A";
  event.sequence = 10;
  event.type = "Route";
  event.label = "into";
  event.start_s = 100;
  event.end_s = 200;
  event.earth_visible_share = Expected{0.75, 1};
  const std::vector<Fault> warnings = doubt_warnings({event}, {}, plan);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(
      warnings[0].what,
      HasSubstr("Route 'into': by the estimate WarnWhen may hold: not sees('Earth'); Earth is "
                "in view for 75 to 100 % of its time"));
  // What surely holds is told otherwise.
  Lack lack;
  lack.kind = LackKind::condition;
  lack.rover_id = "A";
  lack.begin_s = 150;
  lack.end_s = 300;
  EXPECT_TRUE(doubt_warnings({event}, {lack}, plan).empty());
  event.earth_visible_share = Expected::exactly(1);
  EXPECT_TRUE(doubt_warnings({event}, {}, plan).empty());
  event.earth_visible_share = Expected{0.75, 1};
  plan.events.front().warn_when.text = "charge < 0.4";
  EXPECT_TRUE(doubt_warnings({event}, {}, plan).empty());
}

}  // namespace
}  // namespace lsos
