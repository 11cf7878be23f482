#include <gtest/gtest.h>

#include "lua/check/timeline_text.h"

namespace lsos {
namespace {

TEST(Timeline, has_a_line_a_rover_and_day_with_letters_each_20_minutes) {
  const Instant start = *parse_utc("2026-07-01T06:00:00Z").value;
  TimelineRover a{"SEV A", {}, {}, {}};
  a.bars = {{{0, 3600}, 'D'}, {{3600, 3600}, 'A'}, {{3600, 5400}, 'E'}, {{90000, 93600}, 'C'}};
  a.dark = {{3600, 7200}};
  a.unseen = {{6000, 9600}};
  const std::string text = timeline_text({a, {"B", {}, {}, {}}}, start, 93600);
  EXPECT_EQ(text,
            "day 1, 2026-07-01\n"
            "  UTC   06:00    09:00    12:00    15:00    18:00    21:00    00:00    03:00\n"
            "  SEV A DDDEE...................................................................\n"
            "           nnbee\n"
            "  B     ........................................................................\n"
            "day 2, 2026-07-02\n"
            "  UTC   06:00    09:00    12:00    15:00    18:00    21:00    00:00    03:00\n"
            "  SEV A ...CCC\n"
            "  B     ......\n");
}

}  // namespace
}  // namespace lsos
