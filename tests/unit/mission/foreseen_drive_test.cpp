// A rover that is carried along its line in an estimate.
#include "mission/rover/foreseen_drive.h"

#include <gtest/gtest.h>

namespace lsos {
namespace {

constexpr SimTime s{1'000'000};

// 100 m east in 50 s with 500 J, then 100 m north in 100 s with 2000 J.
DriveEstimate round_a_corner() {
  DriveEstimate estimate;
  estimate.line_S_m = {{0, 0, 0}, {100, 0, 0}, {100, 100, 10}};
  estimate.marks = {{}, {100, 100, 50, 500}, {200, 201, 150, 2500}};
  return estimate;
}

TEST(ForeseenDrive, is_between_its_marks_by_time) {
  ForeseenDrive drive(round_a_corner(), 10 * s);
  EXPECT_EQ(drive.next_mark(), 60 * s);
  EXPECT_DOUBLE_EQ(drive.power_w(), 10);
  drive.advance(35 * s);
  EXPECT_TRUE(drive.p_S_m().isApprox(Vec3(50, 0, 0)));
  EXPECT_TRUE(drive.ahead_S().isApprox(Vec2(1, 0)));
  EXPECT_DOUBLE_EQ(drive.energy_j(), 250);
  EXPECT_EQ(drive.next_point(), 0U);  // the path begins with the corner
  drive.advance(110 * s);
  EXPECT_TRUE(drive.p_S_m().isApprox(Vec3(100, 50, 5)));
  EXPECT_TRUE(drive.ahead_S().isApprox(Vec2(0, 1)));
  EXPECT_DOUBLE_EQ(drive.power_w(), 20);
  EXPECT_DOUBLE_EQ(drive.remaining_m(), 50);
  EXPECT_EQ(drive.next_point(), 1U);
  EXPECT_FALSE(drive.has_ended());
}

TEST(ForeseenDrive, ends_at_its_last_mark) {
  ForeseenDrive drive(round_a_corner(), {});
  EXPECT_EQ(drive.end(), 150 * s);
  drive.advance(150 * s);
  EXPECT_TRUE(drive.has_ended());
  EXPECT_TRUE(drive.p_S_m().isApprox(Vec3(100, 100, 10)));
  EXPECT_EQ(drive.power_w(), 0);
  EXPECT_EQ(drive.remaining_m(), 0);
  EXPECT_DOUBLE_EQ(drive.driven_m(), 201);
}

TEST(ForeseenDrive, ends_before_its_line_does_where_it_is_expected_to_fail) {
  DriveEstimate estimate = round_a_corner();
  estimate.marks.pop_back();
  estimate.failure = "stuck";
  ForeseenDrive drive(estimate, {});
  drive.advance(50 * s);
  EXPECT_TRUE(drive.has_ended());
  EXPECT_DOUBLE_EQ(drive.remaining_m(), 100);
}

TEST(ForeseenDrive, backs_up_between_changes_of_gear) {
  DriveEstimate estimate = round_a_corner();
  estimate.gear_changes = {1};
  ForeseenDrive drive(estimate, {});
  drive.advance(25 * s);
  EXPECT_FALSE(drive.is_backward());
  drive.advance(100 * s);
  EXPECT_TRUE(drive.is_backward());
  EXPECT_TRUE(drive.ahead_S().isApprox(Vec2(0, -1)));
}

TEST(ForeseenDrive, that_goes_nowhere_has_ended) {
  DriveEstimate estimate;
  estimate.line_S_m = {{1, 2, 3}};
  estimate.marks = {{}};
  const ForeseenDrive drive(estimate, 5 * s);
  EXPECT_TRUE(drive.has_ended());
  EXPECT_TRUE(drive.p_S_m().isApprox(Vec3(1, 2, 3)));
}

}  // namespace
}  // namespace lsos
