// Long series with few points: no extreme is lost, and short ones stay whole.
#include "product/thinned_rows.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lsos {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ThinnedRows, keep_all_of_a_short_series) {
  ThinnedRows rows({11, 0}, 1000, 1, 1);
  for (int k = 0; k <= 10; ++k) rows.add(k, std::array{0.5 * k});
  rows.finish();
  EXPECT_EQ(rows.size(), 11u);
  EXPECT_EQ(rows.column(0)[3], 1.5);
}

TEST(ThinnedRows, keep_least_and_greatest_of_each_stretch) {
  constexpr int count = 99'990, stretches = 50;  // 2000 in each, but for the last
  ThinnedRows rows({count, 0}, stretches, 1, 1);
  std::array<double, stretches> least, greatest;
  least.fill(1e9);
  greatest.fill(-1e9);
  for (int k = 0; k < count; ++k) {
    // Single peaks that an even choice of samples would miss.
    const double value = std::sin(k * 0.001) + (k % 1999 == 0 ? 5 : 0) - (k % 1777 == 0 ? 5 : 0);
    const auto stretch = static_cast<std::size_t>(k / 2000);
    least[stretch] = std::min(least[stretch], value);
    greatest[stretch] = std::max(greatest[stretch], value);
    rows.add(k, std::array{value});
  }
  rows.finish();
  EXPECT_LE(rows.size(), 4u * stretches);
  EXPECT_TRUE(std::ranges::is_sorted(rows.times_s()));
  EXPECT_EQ(rows.times_s().front(), 0);
  EXPECT_EQ(rows.times_s().back(), count - 1);
  for (std::size_t k = 0; k < stretches; ++k) {
    EXPECT_THAT(rows.column(0), Contains(least[k]));
    EXPECT_THAT(rows.column(0), Contains(greatest[k]));
  }
}

// The rows are those of a short drive and a long wait.
TEST(ThinnedRows, keep_what_happens_in_little_of_the_time) {
  ThinnedRows rows({700, 0}, 1000, 1, 1);
  for (int k = 0; k < 700; ++k) rows.add(k < 200 ? 2 * k : 3600 * k, std::array{std::sin(0.1 * k)});
  rows.finish();
  EXPECT_EQ(rows.size(), 700u);
}

TEST(ThinnedRows, keep_a_short_drive_in_weeks_of_standing) {
  constexpr std::size_t count = 40'000, drive = 200;
  ThinnedRows rows({count, drive}, 1000, 1, 1);
  for (std::size_t k = 0; k < count; ++k) {
    const bool is_moving = k >= 20'000 && k < 20'000 + drive;
    const double value = is_moving ? std::sin(0.3 * static_cast<double>(k)) : 0;
    rows.add(60.0 * static_cast<double>(k), std::array{value}, is_moving);
  }
  rows.finish();
  EXPECT_TRUE(std::ranges::is_sorted(rows.times_s()));
  EXPECT_EQ(std::ranges::count_if(rows.column(0), [](double value) { return value != 0; }), 200);
  EXPECT_LE(rows.size(), 4000u);
}

TEST(ThinnedRows, keep_rows_that_are_wanted) {
  ThinnedRows rows({1000, 500}, 4, 1, 1);
  for (int k = 0; k < 1000; ++k) rows.add(k, std::array{1.0}, k % 2 == 1, {k == 334, k == 666});
  rows.finish();
  EXPECT_THAT(rows.times_s(), Contains(333));
  EXPECT_THAT(rows.times_s(), Contains(666));
  EXPECT_THAT(rows.times_s(), Not(Contains(334)));
}

TEST(ThinnedRows, keep_gaps) {
  ThinnedRows rows({100, 0}, 1, 1, 1);
  for (int k = 0; k < 100; ++k) rows.add(k, std::array{k >= 40 && k < 60 ? nan : 1.0 * k});
  rows.finish();
  EXPECT_THAT(rows.times_s(), ElementsAre(0, 40, 99));
  EXPECT_TRUE(std::isnan(rows.column(0)[1]));
}

TEST(ThinnedRows, keep_extremes_of_all_that_decides_and_the_rest_beside_it) {
  ThinnedRows rows({100, 0}, 1, 3, 2);
  for (int k = 0; k < 100; ++k) {
    rows.add(k, std::array{k == 30 ? 9.0 : 0.0, k == 70 ? -9.0 : 0.0, 2.0 * k});
  }
  rows.finish();
  EXPECT_THAT(rows.times_s(), ElementsAre(0, 30, 70, 99));
  EXPECT_EQ(rows.column(2)[1], 60);
}

TEST(ThinnedRows, know_whether_there_is_any_value) {
  ThinnedRows rows({2, 0}, 10, 1, 1);
  rows.add(0, std::array{nan});
  rows.add(1, std::array{nan});
  rows.finish();
  EXPECT_FALSE(rows.has_values(0));
}

}  // namespace
}  // namespace lsos
