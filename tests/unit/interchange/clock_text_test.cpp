#include "interchange/clock_text.h"

#include <gmock/gmock.h>

namespace lsos {
namespace {

using ::testing::HasSubstr;

const Instant first_day = *parse_utc("2026-02-27T14:00:00Z").value;

TEST(DayOfTable, counts_from_the_date_on_which_the_mission_starts) {
  EXPECT_EQ(date_of_day("1", first_day).value, "2026-02-27");
  EXPECT_EQ(date_of_day("Day 3", first_day).value, "2026-03-01");
  EXPECT_EQ(date_of_day("3.0", first_day).value, "2026-03-01");
  EXPECT_EQ(date_of_day("2026/3/5", first_day).value, "2026-03-05");
  EXPECT_EQ(date_of_day("2026-03-05 00:00:00", first_day).value, "2026-03-05");
  for (const char* wrong : {"0", "-1", "soon", "1.5", "2026-02-30", "99999"}) {
    EXPECT_THAT(date_of_day(wrong, first_day).why, HasSubstr("is no day")) << wrong;
  }
}

TEST(TimeOfTable, is_a_clock_on_its_day_or_counts_from_the_row_before) {
  const TimeContext context{"2026-03-01", first_day};
  const auto read = [&](const char* text) {
    const Parsed<std::string> utc = utc_text(text, context);
    return utc ? format_utc(*parse_utc(*utc.value).value) : utc.why;
  };
  EXPECT_EQ(read("8:05"), "2026-03-01T08:05:00.000Z");
  EXPECT_EQ(read("08:05:30.5"), "2026-03-01T08:05:30.500Z");
  EXPECT_EQ(read("08:00Z"), "2026-03-01T08:00:00.000Z");
  EXPECT_EQ(read("2026-03-01T08:00-07:00"), "2026-03-01T15:00:00.000Z");
  EXPECT_EQ(read("+2 h"), "2026-02-27T16:00:00.000Z");
  EXPECT_EQ(read("+1:30"), "2026-02-27T15:30:00.000Z");
  EXPECT_EQ(read("2026/03/02 06:00:00"), "2026-03-02T06:00:00.000Z");
  EXPECT_EQ(read("2026-03-02"), "2026-03-02T00:00:00.000Z");
  EXPECT_THAT(read("24:00"), HasSubstr("a clock time is from 00:00 to 23:59"));
  EXPECT_THAT(read("+soon"), HasSubstr("is written '+2 h'"));
  EXPECT_EQ(utc_text("soon", context).value, "soon");  // the plan's reader says what is wrong
  EXPECT_THAT(utc_text("+2 h", {"", {}}).why, HasSubstr("says a start to count from"));
  EXPECT_THAT(utc_text("08:00", {"", {}}).why, HasSubstr("a clock time needs a Day"));
}

TEST(TimeOfTable, is_no_range_of_clocks) {
  const TimeContext context{"2026-03-01", first_day};
  for (const char* range : {"8:00-10:00", "08:00 - 10:00", "08:00-07:00", "08:00+02:00",
                            "8:00 \xe2\x80\x93 10:00", "8:00 to 10:00", "2026-03-01 8:00-10:00"}) {
    EXPECT_THAT(utc_text(range, context).why, HasSubstr("is a range, or a clock with a zone; the "
                                                        "start alone is wanted, in UTC"))
        << range;
  }
}

TEST(TimeOfTable, after_another_has_a_unit) {
  const TimeContext context{"2026-03-01", first_day};
  EXPECT_EQ(utc_text("+4", context).why, "'+4' has no unit; '+4 h' or '+4 min' is wanted");
  EXPECT_THAT(utc_text("+ 90.5", context).why, HasSubstr("'+90.5 min' is wanted"));
  EXPECT_EQ(utc_text("+0", context).value, "2026-02-27T14:00:00.000Z");
}

TEST(DayClock, reads_back_as_the_same_instant) {
  const auto written = [](const char* utc) {
    const auto found = day_clock(*parse_utc(utc).value, first_day);
    return found ? std::to_string(found->day) + " " + found->clock : "none";
  };
  EXPECT_EQ(written("2026-02-27T00:00:00Z"), "1 00:00");
  EXPECT_EQ(written("2026-03-01T08:05:30Z"), "3 08:05:30");
  EXPECT_EQ(written("2026-03-01T08:05:00.5Z"), "3 08:05:00.5");
  EXPECT_EQ(written("2026-03-01T08:00:00.000001Z"), "none");
  EXPECT_EQ(written("2026-02-26T23:59:59Z"), "none");
}

}  // namespace
}  // namespace lsos
