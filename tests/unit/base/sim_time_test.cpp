#include "base/sim_time.h"

#include <gtest/gtest.h>

#include "base/moment_text.h"

namespace lsos {
namespace {

TEST(SimTime, sums_of_tenths_are_exact) {
  SimTime sum{};
  for (int i = 0; i < 36'000; ++i) sum += exchange_period;
  EXPECT_EQ(sum, std::chrono::hours(1));
  EXPECT_EQ(seconds(sum), 3600.0);
}

TEST(SimTime, takes_the_nearest_microsecond) {
  EXPECT_EQ(from_seconds(0.1), SimTime{100'000});
  EXPECT_EQ(from_seconds(1.0000006), SimTime{1'000'001});
  EXPECT_EQ(from_seconds(-0.25), SimTime{-250'000});
  EXPECT_EQ(from_seconds(9e12).count(), 9'000'000'000'000'000'000);
}

TEST(SimTime, seconds_and_back_is_the_same_over_a_year) {
  for (const std::int64_t count : {1LL, 33'333LL, 31'622'399'999'999LL, -7LL}) {
    EXPECT_EQ(from_seconds(seconds(SimTime{count})).count(), count);
  }
}

TEST(SimTime, rounds_up_to_the_exchange_at_or_after) {
  EXPECT_EQ(round_up_to_exchange(SimTime{0}), SimTime{0});
  EXPECT_EQ(round_up_to_exchange(SimTime{1}), SimTime{100'000});
  EXPECT_EQ(round_up_to_exchange(SimTime{100'000}), SimTime{100'000});
  EXPECT_EQ(round_up_to_exchange(SimTime{100'001}), SimTime{200'000});
}

TEST(SimTime, rounds_negative_times_up_too) {
  EXPECT_EQ(round_up_to_exchange(SimTime{-1}), SimTime{0});
  EXPECT_EQ(round_up_to_exchange(SimTime{-100'000}), SimTime{-100'000});
  EXPECT_EQ(round_up_to_exchange(SimTime{-100'001}), SimTime{-100'000});
}

TEST(SimTime, of_the_second_day_on_is_told_with_its_day) {
  EXPECT_EQ(moment_text(from_seconds(1200.5)), "1200.5 s");
  EXPECT_EQ(moment_text(from_seconds(86399.9)), "86399.9 s");
  EXPECT_EQ(moment_text(from_seconds(86400)), "86400 s (day 2, 00:00:00)");
  EXPECT_EQ(moment_text(from_seconds(384471.6)), "384471.6 s (day 5, 10:47:51)");
}

}  // namespace
}  // namespace lsos
