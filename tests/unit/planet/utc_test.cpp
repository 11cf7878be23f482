#include "planet/utc.h"
#include "base/parsed.h"

#include <gmock/gmock.h>

namespace lsos {
namespace {

using ::testing::HasSubstr;

Instant utc(std::string_view text) {
  const Parsed<Instant> parsed = parse_utc(text);
  EXPECT_TRUE(parsed) << parsed.why;
  return parsed.value.value_or(Instant{});
}

double difference_s(std::string_view later, std::string_view earlier) {
  return seconds(utc(later) - utc(earlier));
}

TEST(Utc, counts_from_2000_in_tai) {
  // TAI was 32 s ahead of UTC in 2000 (IERS Bulletin C).
  EXPECT_EQ(utc("2000-01-01T00:00:00Z").tai_us, 32'000'000);
  EXPECT_EQ(utc("1999-12-31T23:59:28Z").tai_us, 0);
  EXPECT_EQ(utc("1999-12-31T23:59:27.999999Z").tai_us, -1);
}

TEST(Utc, differences_count_leap_seconds) {
  EXPECT_EQ(difference_s("2017-01-01T00:00:00Z", "2016-12-31T23:59:59Z"), 2);
  EXPECT_EQ(difference_s("2016-01-01T00:00:00Z", "2015-12-31T23:59:59Z"), 1);
  // 22 leap seconds from 1972-07 to 1999-01 after the ten of 1972-01; 5 from 2000 to 2017.
  EXPECT_EQ(difference_s("2017-01-02T00:00:00Z", "2000-01-01T00:00:00Z"), 6211 * 86400.0 + 5);
  EXPECT_EQ(difference_s("2000-01-01T00:00:00Z", "1972-01-01T00:00:00Z"), 10227 * 86400.0 + 22);
  EXPECT_EQ(difference_s("2026-07-01T12:00:00Z", "2026-07-01T00:00:00Z"), 43200);
}

TEST(Utc, second_60_exists_in_leap_seconds_only) {
  EXPECT_EQ(difference_s("2016-12-31T23:59:60Z", "2016-12-31T23:59:59Z"), 1);
  EXPECT_EQ(difference_s("2017-01-01T00:00:00Z", "2016-12-31T23:59:60.25Z"), 0.75);
  EXPECT_EQ(utc("2017-01-01T01:59:60+02:00"), utc("2016-12-31T23:59:60Z"));
  for (const char* text : {"2015-12-31T23:59:60Z", "2016-12-31T23:58:60Z", "2016-12-31T12:00:60Z",
                           "2016-12-31T23:59:60+01:00", "2016-12-31T23:59:61Z"}) {
    const Parsed<Instant> parsed = parse_utc(text);
    EXPECT_FALSE(parsed) << text;
    EXPECT_THAT(parsed.why, HasSubstr("60 in a leap second only"));
  }
}

TEST(Utc, reads_the_forms_of_iso_8601) {
  const Instant noon = utc("2026-07-01T12:00:00Z");
  for (const char* text :
       {"2026-07-01 12:00", "2026-07-01T12:00", "2026-07-01T14:00:00.0+02:00",
        "2026-07-01T06:30-05:30", "2026-07-01T12:00:00,000z", " 2026-07-01t12:00:00 Z ",
        "2026-07-02T01:00:00+1300", "2026-07-01T00:00:00-12"}) {
    EXPECT_EQ(utc(text), noon) << text;
  }
  EXPECT_EQ(utc("2026-07-01"), utc("2026-07-01T00:00:00Z"));
  EXPECT_EQ((utc("2026-07-01T12:00:00.5Z") - noon).count(), 500'000);
  EXPECT_EQ((utc("2026-07-01T12:00:00.0000014Z") - noon).count(), 1);
  EXPECT_EQ((utc("2026-07-01T12:00:00.123456Z") - noon).count(), 123'456);
}

// Mission operations write days of the year; they are counted by the calendar of Meeus (1998),
// chapter 7: day 246 of a common year is 3 September, of a leap year 2 September.
TEST(Utc, reads_days_of_the_year) {
  const Instant time = utc("2026-09-03T06:00:00Z");
  for (const char* text : {"2026-246T06:00:00Z", "2026-246T06:00", "2026-246 06:00:00.000",
                           "2026246T060000Z", "2026-246T08:00:00+02:00", "2026-246T0600Z"}) {
    EXPECT_EQ(utc(text), time) << text;
  }
  EXPECT_EQ(utc("2024-246"), utc("2024-09-02"));
  EXPECT_EQ(utc("2024-366"), utc("2024-12-31"));
  EXPECT_EQ(utc("2026-001"), utc("2026-01-01"));
  EXPECT_EQ(difference_s("2016-366T23:59:60Z", "2016-366T23:59:59Z"), 1);
  EXPECT_THAT(parse_utc("2026-366").why, HasSubstr("day 366 of the year 2026: 1..365 is allowed"));
  EXPECT_THAT(parse_utc("2026-000").why, HasSubstr("day 0 of the year 2026"));
}

TEST(Utc, reads_the_basic_format) {
  const Instant time = utc("2026-09-03T06:00:00Z");
  for (const char* text : {"20260903T060000Z", "20260903T0600Z", "20260903T060000",
                           "20260903 060000Z", "20260903T080000+0200", "20260903T06:00:00Z",
                           "2026-09-03T060000.000Z", "2026-09-03 06:00:00 UTC"}) {
    EXPECT_EQ(utc(text), time) << text;
  }
  EXPECT_EQ(utc("20260903"), utc("2026-09-03"));
  for (const char* text : {"202609", "202609030", "2026-9-3", "20260903T06", "20260903T06000",
                           "2026-09", "20260903060000"}) {
    EXPECT_FALSE(parse_utc(text)) << text;
  }
}

TEST(Utc, says_what_is_wrong_with_a_text) {
  const auto why = [](std::string_view text) {
    const Parsed<Instant> parsed = parse_utc(text);
    EXPECT_FALSE(parsed) << text;
    return parsed.why;
  };
  EXPECT_EQ(why("tomorrow"),
            "'tomorrow' is no UTC time: ISO 8601 is allowed, such as '2026-07-01T12:00:00Z', or "
            "with the day of the year '2026-182T12:00:00Z'");
  EXPECT_EQ(why("2026-13-01"), "'2026-13-01' is no UTC time: month 13: 1..12 is allowed");
  EXPECT_THAT(why("2026-02-29"), HasSubstr("day 29: 1..28 is allowed"));
  EXPECT_THAT(why("2026-07-01T24:00"), HasSubstr("hour 24: 0..23 is allowed"));
  EXPECT_THAT(why("2026-07-01T12:60"), HasSubstr("minute 60: 0..59 is allowed"));
  EXPECT_THAT(why("1950-07-01"), HasSubstr("year 1950: 1960..2100 is allowed"));
  EXPECT_THAT(why("2026-07-01T12"), HasSubstr("a time of day is written as '12:00'"));
  EXPECT_THAT(why("2026-07-01T12:00:5"), HasSubstr("seconds are written with two digits"));
  EXPECT_THAT(why("2026-07-01T12:00:00."), HasSubstr("digits must follow the decimal point"));
  EXPECT_THAT(why("2026-07-01T12:00 CEST"), HasSubstr("only a zone such as 'Z' or '+02:00'"));
  EXPECT_THAT(why("2026-07-01T12:00+2"), HasSubstr("a zone is written as '+02:00'"));
  EXPECT_THAT(why("2026-07-01T12:00+15:00"), HasSubstr("from -14:00 to +14:00"));
  EXPECT_THAT(why("2026-07-01T12:00Z?"), HasSubstr("nothing may follow"));
  EXPECT_THAT(why("2026-07-01x12:00"), HasSubstr("'T' or a space"));
  EXPECT_THAT(why(""), HasSubstr("ISO 8601 is allowed"));
  EXPECT_THAT(why("-026-07-01"), HasSubstr("ISO 8601 is allowed"));
}

TEST(Utc, writes_milliseconds_rounded) {
  EXPECT_EQ(format_utc(utc("2026-07-01T12:00:00Z")), "2026-07-01T12:00:00.000Z");
  EXPECT_EQ(format_utc(utc("2026-07-01T12:00:00.0004994Z")), "2026-07-01T12:00:00.000Z");
  EXPECT_EQ(format_utc(utc("2026-07-01T12:00:00.0005Z")), "2026-07-01T12:00:00.001Z");
  EXPECT_EQ(format_utc(utc("2025-12-31T23:59:59.9996Z")), "2026-01-01T00:00:00.000Z");
  EXPECT_EQ(format_utc(utc("2016-12-31T23:59:59.9996Z")), "2016-12-31T23:59:60.000Z");
  EXPECT_EQ(format_utc(utc("2016-12-31T23:59:60.9994Z")), "2016-12-31T23:59:60.999Z");
  EXPECT_EQ(format_utc(utc("2016-12-31T23:59:60.9996Z")), "2017-01-01T00:00:00.000Z");
}

TEST(Utc, what_is_written_reads_back_equal) {
  for (const char* text :
       {"1972-06-30T23:59:60.500Z", "1972-07-01T00:00:00.000Z", "1999-12-31T23:59:28.000Z",
        "2016-12-31T23:59:59.999Z", "2016-12-31T23:59:60.123Z", "2017-01-01T00:00:00.000Z",
        "2100-12-31T23:59:59.999Z", "2024-02-29T12:34:56.789Z"}) {
    EXPECT_EQ(format_utc(utc(text)), text);
    EXPECT_EQ(utc(format_utc(utc(text))), utc(text));
  }
}

TEST(Utc, the_years_before_leap_seconds_follow_the_drifting_offset) {
  // TAI - UTC = 4.2131700 s + (MJD - 39126) x 0.002592 s from 1968-02-01 (ERFA eraDat, IERS).
  const std::int64_t midnight_us = utc("1970-01-01T00:00:00Z").tai_us;
  const double offset_s = 4.2131700 + (40587 - 39126) * 0.002592;
  EXPECT_NEAR(static_cast<double>(midnight_us) * 1e-6, -10957 * 86400.0 + offset_s, 1e-6);
  for (const char* text : {"1960-01-01T00:00:00.000Z", "1965-06-30T18:45:12.250Z",
                           "1968-01-31T23:59:59.800Z", "1971-12-31T23:59:59.500Z"}) {
    EXPECT_EQ(format_utc(utc(text)), text);
  }
}

TEST(Utc, adds_simulated_time) {
  const Instant start = utc("2016-12-31T23:59:59Z");
  EXPECT_EQ(format_utc(start + from_seconds(1.5)), "2016-12-31T23:59:60.500Z");
  EXPECT_EQ(format_utc(start + from_seconds(2)), "2017-01-01T00:00:00.000Z");
}

}  // namespace
}  // namespace lsos
