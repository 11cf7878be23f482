#include "interchange/outline_item.h"

#include <gmock/gmock.h>

#include "unit/plan/plan_fixture.h"

namespace lsos::test {
namespace {

using ::testing::Pair;
using ::testing::UnorderedElementsAre;

OutlineFields read(const char* item) {
  const Parsed<OutlineFields> fields = parse_item(item, declarations());
  return fields ? *fields.value : OutlineFields{{"why", fields.why}};
}

TEST(OutlineItem, has_a_clock_at_either_end) {
  for (const char* item : {"08:00 drive straight to Ridge", "08:00 - Drive straight TO Ridge",
                           "drive straight to Ridge at 08:00", "08:00: drive straight to Ridge",
                           "08:00 \xe2\x80\x93 Route at Ridge"}) {
    EXPECT_THAT(read(item), UnorderedElementsAre(Pair("StartTime", "08:00"), Pair("Type", "Route"),
                                                 Pair("Place", "Ridge")))
        << item;
  }
}

TEST(OutlineItem, has_units_in_words) {
  for (const char* item : {"pause 2 hours", "Pause for 2 hrs", "wait 2 Hours"}) {
    const OutlineFields fields = read(item);
    ASSERT_EQ(fields.size(), 2u) << item;
    EXPECT_EQ(fields[0].first, "Duration") << item;
  }
  EXPECT_THAT(
      read("drive straight to Ridge at 5 kph"),
      UnorderedElementsAre(Pair("Type", "Route"), Pair("Place", "Ridge"), Pair("Speed", "5 kph")));
}

TEST(OutlineItem, says_where) {
  EXPECT_THAT(read("pause 20 minutes at Ridge"),
              UnorderedElementsAre(Pair("Type", "Pause"), Pair("Duration", "20 minutes"),
                                   Pair("Place", "Ridge")));
  EXPECT_THAT(
      read("wait until 09:00 at (0.1, 2)"),
      UnorderedElementsAre(Pair("Type", "Wait"), Pair("Until", "09:00"), Pair("Place", "0.1, 2")));
}

}  // namespace
}  // namespace lsos::test
