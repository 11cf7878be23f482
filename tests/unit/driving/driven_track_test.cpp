#include "driving/driven_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/segment.h"

namespace lsos {
namespace {

std::vector<Vec2> line_of(const DrivenTrack& track) {
  std::vector<Vec2> line = track.corners_from(0);
  line.push_back(track.here_S_m());
  return line;
}

double to_line_m(const std::vector<Vec2>& line, const Vec2& p) {
  double least_m = 1e9;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    least_m = std::min(least_m, point_distance_m(line[i], line[i + 1], p));
  }
  return least_m;
}

// Motion of 3 cm an exchange along a straight line.
void drive(DrivenTrack& track, const Vec2& from, const Vec2& to) {
  const int steps = static_cast<int>((to - from).norm() / 0.03);
  for (int i = 0; i <= steps; ++i) track.add(from + (to - from) * i / steps);
}

TEST(DrivenTrack, stays_near_each_place_and_keeps_few_corners) {
  DrivenTrack track;
  std::vector<Vec2> places;
  for (double turn_rad = 0; turn_rad < 6; turn_rad += 0.002) {
    places.push_back(20 * Vec2(std::cos(turn_rad), std::sin(turn_rad)));
    track.add(places.back());
  }
  for (const Vec2& place : places) {
    EXPECT_LE(to_line_m(line_of(track), place), 2 * DrivenTrack::deviation_m);
  }
  EXPECT_LT(track.corner_count(), 60u);
  EXPECT_EQ(track.here_S_m(), places.back());
}

TEST(DrivenTrack, has_one_corner_where_the_rover_turned_on_the_spot) {
  DrivenTrack track;
  drive(track, {0, 0}, {9, 0});
  drive(track, {9, 0}, {9, 9});
  const std::vector<Vec2> corners = track.corners_from(1);
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_LT((corners.front() - Vec2(9, 0)).norm(), 0.3);
}

TEST(DrivenTrack, is_entered_at_its_nearest_place_and_of_several_at_the_latest) {
  DrivenTrack track;
  drive(track, {0, 0}, {30, 0});
  const DrivenTrack::Entry entry = track.nearest({12, 5});
  EXPECT_NEAR(entry.p_S_m.x(), 12, 0.1);
  EXPECT_NEAR(entry.to_here_m, 18, 0.1);
  EXPECT_GT(track.corners_from(entry.next_corner).front().x(), 12);
  drive(track, {30, 0}, {0, 0});
  EXPECT_NEAR(track.nearest({12, 5}).to_here_m, 12, 0.5);
}

TEST(DrivenTrack, forgets_what_lies_far_behind) {
  DrivenTrack track;
  for (int i = 0; i < 20000; ++i) track.add({i * 0.5, 0});
  const std::size_t kept = track.corners_from(0).size();
  EXPECT_LT(kept, track.corner_count());
  EXPECT_NEAR(track.nearest({-100, 0}).to_here_m, DrivenTrack::kept_m, 0.1 * DrivenTrack::kept_m);
  EXPECT_EQ(track.corners_from(track.corner_count() - 3).size(), 3u);
}

TEST(DrivenTrack, goes_on_the_same_after_it_was_saved) {
  DrivenTrack track, restored;
  drive(track, {0, 0}, {7.3, 2});
  Archive out = Archive::writer();
  track.archive(out);
  Archive in = Archive::reader(out.bytes());
  restored.archive(in);
  for (DrivenTrack* each : {&track, &restored}) drive(*each, {7.3, 2}, {9, 20});
  EXPECT_EQ(line_of(track), line_of(restored));
}

}  // namespace
}  // namespace lsos
