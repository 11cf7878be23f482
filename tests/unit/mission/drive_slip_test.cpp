// Slip of driving, compared with sums over the whole series.
#include "mission/rover/drive_slip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace lsos {
namespace {

DriveSlip::Motion driving(double slip) {
  DriveSlip::Motion motion;
  motion.is_commanded = true;
  motion.requested_mps = motion.command_mps = motion.speed_mps = 2;
  motion.cruise_mps = 2;
  motion.slip = slip;
  motion.slip_max = 2 * slip;
  return motion;
}

TEST(DriveSlip, is_what_the_whole_series_says) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.04, 0.03);
  std::vector<double> slips;
  DriveSlip slip;
  double greatest = -1, last = 0;
  for (int k = 0; k < 5000; ++k) {
    last = 0.9 * last + 0.1 * normal(random);
    slips.push_back(last);
    slip.add(driving(last));
    if (k < 9) continue;
    double sum = 0;
    for (int i = k - 9; i <= k; ++i) sum += slips[static_cast<std::size_t>(i)];
    greatest = std::max(greatest, sum / 10);
    EXPECT_NEAR(slip.now(), sum / 10, 1e-12);
  }
  EXPECT_NEAR(slip.greatest(), greatest, 1e-12);
  std::ranges::sort(slips);
  EXPECT_NEAR(slip.p95(), slips[4749], 0.5 / SlipHistogram::bins) << "rank 4750 of 5000";
}

TEST(DriveSlip, is_of_driving_alone) {
  DriveSlip slip;
  DriveSlip::Motion setting_off = driving(0.96);
  setting_off.speed_mps = 0.9;
  setting_off.command_mps = 0.99;
  DriveSlip::Motion turning = driving(0.7);
  turning.is_commanded = false;
  for (int k = 0; k < 20; ++k) slip.add(setting_off);
  for (int k = 0; k < 20; ++k) slip.add(turning);
  EXPECT_TRUE(std::isnan(slip.greatest()));
  EXPECT_TRUE(std::isnan(slip.p95()));
  EXPECT_TRUE(std::isnan(slip.now()));
  for (int k = 0; k < 9; ++k) slip.add(driving(0.02));
  EXPECT_EQ(slip.greatest(), 0.02) << "not yet a second: the percentile";
  EXPECT_EQ(slip.p95(), 0.02);
  slip.add(driving(0.02));
  EXPECT_NEAR(slip.greatest(), 0.02, 1e-15);
  for (int k = 0; k < 3; ++k) slip.add(setting_off);
  for (int k = 0; k < 9; ++k) slip.add(driving(0.5));
  EXPECT_NEAR(slip.greatest(), 0.02, 1e-15) << "a second has no gap";
}

TEST(DriveSlip, knows_nothing_of_a_rover_that_creeps) {
  DriveSlip slip;
  DriveSlip::Motion creeping = driving(0.3);
  creeping.requested_mps = creeping.command_mps = 0.04;
  creeping.speed_mps = 0.04;
  for (int k = 0; k < 20; ++k) slip.add(creeping);
  EXPECT_TRUE(std::isnan(slip.greatest())) << "below 0.05 m/s";
  EXPECT_NEAR(slip.now(), 0.3, 1e-15) << "what conditions look at";
}

// The wheels turn as commanded while the rover loses its speed.
TEST(DriveSlip, shows_conditions_a_rover_that_digs_itself_in) {
  DriveSlip slip;
  DriveSlip::Motion stuck = driving(0.95);
  stuck.speed_mps = 0.1;
  for (int k = 0; k < 10; ++k) slip.add(stuck);
  EXPECT_NEAR(slip.now(), 0.95, 1e-15);
  EXPECT_NEAR(slip.now_max(), 1.9, 1e-15);
  EXPECT_TRUE(std::isnan(slip.greatest()));
}

TEST(DriveSlip, is_saved_and_read_back) {
  DriveSlip slip, same;
  for (int k = 0; k < 95; ++k) slip.add(driving(0.001 * (k % 13)));
  Archive writer = Archive::writer();
  writer(slip);
  Archive reader = Archive::reader(writer.bytes());
  reader(same);
  EXPECT_TRUE(reader.is_exhausted());
  for (DriveSlip* one : {&slip, &same}) {
    for (int k = 0; k < 4; ++k) one->add(driving(0.02));
  }
  EXPECT_EQ(slip.greatest(), same.greatest());
  EXPECT_EQ(slip.p95(), same.p95());
  EXPECT_EQ(slip.now(), same.now());
  EXPECT_EQ(slip.p95(), 0.012);
}

// A rover whose cruise speed is 0.05 m/s is never faster than that.
TEST(DriveSlip, of_a_slow_rover_is_counted_from_a_tenth_of_its_cruise_speed) {
  DriveSlip::Motion slow = driving(0.3);
  slow.cruise_mps = slow.requested_mps = slow.command_mps = 0.05;
  slow.speed_mps = 0.035;
  DriveSlip slip;
  for (int k = 0; k < 20; ++k) slip.add(slow);
  EXPECT_NEAR(slip.greatest(), 0.3, 1e-15);
  EXPECT_NEAR(slip.p95(), 0.3, 1e-15);
}

TEST(DriveSlip, knows_what_is_left_out) {
  DriveSlip::Motion spinning = driving(0.6);
  spinning.speed_mps = 0.4 * spinning.requested_mps;
  DriveSlip slip;
  for (int k = 0; k < 700; ++k) slip.add(spinning);
  EXPECT_TRUE(std::isnan(slip.p95())) << "never above half the requested speed";
  EXPECT_NEAR(slip.driven_s(), 70, 1e-9);
  EXPECT_NEAR(slip.mean_mps(), 0.8, 1e-9);
  EXPECT_NEAR(slip.mean_requested_mps(), 2, 1e-9);
  EXPECT_NEAR(slip.greatest_rolling(), 0.6, 1e-12);
}

}  // namespace
}  // namespace lsos
