// Times moved by a span keep their form.
#include "edit/shifted_time.h"

#include <gmock/gmock.h>

#include "base/sim_time.h"

namespace lsos::test {
namespace {

constexpr SimTime one_hour = day_length / 24;

TEST(ShiftedTime, keeps_the_form_that_it_has) {
  EXPECT_EQ(shifted_utc("2026-07-01T12:00:00Z", day_length), "2026-07-02T12:00:00Z");
  EXPECT_EQ(shifted_utc("2026-07-01T12:00:00.500Z", day_length), "2026-07-02T12:00:00.500Z");
  EXPECT_EQ(shifted_utc("2026-07-01 12:00", -day_length), "2026-06-30 12:00");
  EXPECT_EQ(shifted_utc("2026-07-01", 2 * day_length), "2026-07-03");
  EXPECT_EQ(shifted_utc("2026-07-01T23:30:00+02:00", one_hour), "2026-07-02T00:30:00+02:00");
  EXPECT_EQ(shifted_utc("2026-07-01T23:30-0130", one_hour), "2026-07-02T00:30-0130");
  EXPECT_EQ(shifted_utc("2026-12-31T23:00:00+01", 2 * one_hour), "2027-01-01T01:00:00+01");
}

TEST(ShiftedTime, says_more_where_the_form_cannot_say_it) {
  EXPECT_EQ(shifted_utc("2026-07-01", one_hour), "2026-07-01T01:00Z");
  EXPECT_EQ(shifted_utc("2026-07-01 12:00", SimTime{30'000'000}), "2026-07-01 12:00:30");
  EXPECT_EQ(shifted_utc("2026-07-01T12:00Z", SimTime{30'250'000}), "2026-07-01T12:00:30.25Z");
  EXPECT_EQ(shifted_utc("2026-182T12:00:00Z", day_length), "2026-07-02T12:00:00.000Z");
}

TEST(ShiftedTime, counts_a_leap_second) {
  EXPECT_EQ(shifted_utc("2016-12-31T12:00:00Z", day_length), "2017-01-01T11:59:59Z");
}

TEST(ShiftedTime, of_a_duration_is_in_seconds) {
  EXPECT_EQ(shifted_duration("1 h", one_hour), "7200 s");
  EXPECT_EQ(shifted_duration("PT30M", -one_hour), "-1800 s");
}

}  // namespace
}  // namespace lsos::test
