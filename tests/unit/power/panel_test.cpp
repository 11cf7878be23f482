#include "power/panel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "power/panel_array.h"

namespace lsos {
namespace {

constexpr double pi = std::numbers::pi;
constexpr AngleLimits all_round{-pi, pi}, upper{0, pi / 2};

PanelSpec panel() {
  PanelSpec panel;
  panel.name = "Roof";
  panel.p_B_m = {1, 2, 3};
  panel.length_m = 2;
  panel.width_m = 4;
  panel.efficiency = 0.3;
  panel.factor = 0.5;
  panel.azimuth = all_round;
  panel.elevation = upper;
  panel.rate_radps = 0.1;
  panel.motor_w = 50;
  return panel;
}

Vec3 direction(double azimuth_rad, double elevation_rad) {
  return {std::cos(elevation_rad) * std::cos(azimuth_rad),
          -std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad)};
}

double cosine(const PanelSpec& spec, const PanelAngles& angles, const Vec3& sun_B) {
  return pose(spec, angles).normal_B().dot(sun_B);
}

TEST(Panel, faces_where_its_angles_say) {
  EXPECT_TRUE(pose(panel(), {}).normal_B().isApprox(Vec3::UnitZ()));
  EXPECT_TRUE(pose(panel(), {pi / 2, 0}).normal_B().isApprox(-Vec3::UnitY()));  // right
  EXPECT_TRUE(pose(panel(), {1.2, 0.4}).normal_B().isApprox(direction(1.2, 0.4)));
  EXPECT_TRUE(pose(panel(), {}).half_u_B_m.isApprox(Vec3(1, 0, 0)));
  EXPECT_TRUE(pose(panel(), {}).half_v_B_m.isApprox(Vec3(0, 2, 0)));
}

TEST(Panel, faces_the_sun_with_two_free_axes) {
  for (double azimuth = -3; azimuth < 3; azimuth += 0.7) {
    const Vec3 sun_B = direction(azimuth, 0.3);
    EXPECT_NEAR(cosine(panel(), facing(panel(), {}, sun_B), sun_B), 1, 1e-12);
  }
}

// No other angles within the limits do better: all of them are tried, a degree apart.
TEST(Panel, with_one_axis_or_narrow_limits_comes_as_near_as_it_can) {
  PanelSpec one_axis = panel();
  one_axis.azimuth = {pi / 2, pi / 2};
  one_axis.elevation = {0, pi};
  PanelSpec spinning = panel();
  spinning.elevation = {0.5, 0.5};
  PanelSpec narrow = panel();
  narrow.azimuth = {-0.5, 0.9};
  RandomStream random(1);
  for (const PanelSpec& spec : {one_axis, spinning, narrow}) {
    for (int k = 0; k < 30; ++k) {
      const Vec3 sun_B = direction(random.uniform(-pi, pi), random.uniform(-0.2, pi / 2));
      double best = -1;
      constexpr double step = pi / 180;
      for (double a = spec.azimuth.least_rad; a <= spec.azimuth.most_rad + 1e-9; a += step) {
        for (double e = spec.elevation.least_rad; e <= spec.elevation.most_rad + 1e-9; e += step) {
          best = std::max(best, cosine(spec, {a, e}, sun_B));
        }
      }
      EXPECT_GT(cosine(spec, facing(spec, {}, sun_B), sun_B), best - 3e-4);
    }
  }
}

TEST(Panel, turns_the_shorter_way_round_at_its_rate) {
  const PanelAngles from{3, 0.5}, to{-3, 0.6};
  const double turn_rad = 2 * pi - 6;
  EXPECT_NEAR(turn_s(panel(), from, to), turn_rad / 0.1, 1e-12);
  const PanelAngles half = turned(panel(), from, to, turn_rad / 0.1 / 2);
  EXPECT_NEAR(std::abs(half.azimuth_rad), pi, 1e-9);
  EXPECT_NEAR(half.elevation_rad, 0.6, 1e-12);
  EXPECT_NEAR(turned(panel(), from, to, 100).azimuth_rad, -3, 1e-12);
  PanelSpec stopped = panel();
  stopped.azimuth = {-3.1, 3.1};  // the azimuth must not pass behind
  EXPECT_NEAR(turn_s(stopped, from, to), 60, 1e-9);
}

TEST(Panel, makes_power_of_what_it_sees) {
  EXPECT_DOUBLE_EQ(panel_power_w(panel(), 0.5, 0.8, 1000), 0.5 * 0.8 * 8 * 0.3 * 0.5 * 1000);
  EXPECT_EQ(panel_power_w(panel(), 1, -0.1, 1000), 0);
}

TEST(PanelArray, follows_the_sun_when_told_so) {
  PanelArray array({panel()});
  PanelSurroundings around;
  around.sun_B = direction(0.5, 0.2);
  around.is_sun_up = true;
  array.aim(around, SimTime{});
  EXPECT_FALSE(array.is_turning(SimTime{}));  // no command yet
  array.steer(0, {SteerMode::track, {}});
  array.aim(around, SimTime{});
  EXPECT_TRUE(array.is_turning(SimTime{}));
  EXPECT_EQ(array.motors_w(SimTime{}), 50);
  // pi/2 - 0.2 of elevation at 0.1 rad/s, rounded up to the next exchange.
  const SimTime end = *array.next_end(SimTime{});
  EXPECT_EQ(end, SimTime{13'800'000});
  EXPECT_FALSE(array.is_turning(end));
  EXPECT_EQ(array.motors_w(end), 0);
  EXPECT_NEAR(array.pose_at(0, end).normal_B().dot(around.sun_B), 1, 1e-12);
  around.is_sun_up = false;  // it does not move at night
  around.sun_B = direction(0.5, -0.2);
  array.aim(around, end);
  EXPECT_FALSE(array.is_turning(end));
}

TEST(PanelArray, points_about_the_ground_whichever_way_the_rover_stands) {
  PanelArray array({panel()});
  array.steer(0, {SteerMode::point, {pi / 2, 0.3}});  // east
  PanelSurroundings around;
  around.north_B = Vec3::UnitY();  // the rover heads east
  array.aim(around, SimTime{});
  const SimTime end = *array.next_end(SimTime{});
  EXPECT_TRUE(array.pose_at(0, end).normal_B().isApprox(direction(0, 0.3), 1e-9));
}

TEST(PanelArray, is_of_no_use_until_it_is_up) {
  PanelSpec folded = panel();
  folded.is_stowable = folded.is_stowed = true;
  folded.deploy_s = 30;
  folded.deploy_w = 7;
  PanelArray array({folded});
  EXPECT_FALSE(array.is_up(0, SimTime{}));
  EXPECT_EQ(array.deploy(0, true, {}, SimTime{}), 30);
  EXPECT_FALSE(array.is_up(0, SimTime{29'900'000}));
  EXPECT_EQ(array.motors_w(SimTime{29'900'000}), 7);
  EXPECT_TRUE(array.is_up(0, SimTime{30'000'000}));
  EXPECT_EQ(array.motors_w(SimTime{30'000'000}), 0);
  EXPECT_EQ(array.deploy(0, true, {}, SimTime{40'000'000}), 0);  // it is deployed already
  EXPECT_EQ(array.deploy(0, false, 5, SimTime{40'000'000}), 5);
  EXPECT_FALSE(array.is_up(0, SimTime{40'000'000}));
}

// This panel can face only the upper half of the sky.
TEST(PanelArray, tells_of_a_panel_that_stopped_at_its_limit) {
  PanelArray panels({panel()});
  const PanelSurroundings level;  // the nose points north
  panels.steer(0, {SteerMode::point, {pi / 2, -pi / 3}});
  panels.aim(level, SimTime{});
  const SimTime later = from_seconds(1000);
  EXPECT_TRUE(panels.misses(SimTime{1}).empty());  // it is still turning
  const std::vector<PanelMiss> misses = panels.misses(later);
  ASSERT_EQ(misses.size(), 1u);
  EXPECT_EQ(misses[0].panel, "Roof");
  EXPECT_NEAR(misses[0].reached.azimuth_rad, pi / 2, 1e-9);
  EXPECT_NEAR(misses[0].reached.elevation_rad, 0, 1e-9);
  EXPECT_NEAR(misses[0].off_rad, pi / 3, 1e-9);

  panels.steer(0, {SteerMode::fixed, {pi, 2}});
  panels.aim(level, later);
  ASSERT_EQ(panels.misses(2 * later).size(), 1u);
  EXPECT_NEAR(panels.misses(2 * later)[0].reached.elevation_rad, pi / 2, 1e-9);
}

TEST(PanelArray, misses_the_sun_that_it_tracks_only_when_it_is_stuck) {
  PanelArray panels({panel()});
  panels.steer(0, {SteerMode::track, {}});
  PanelSurroundings low;
  low.is_sun_up = true;
  low.sun_B = direction(pi / 2, 0.2);
  panels.aim(low, SimTime{});
  const SimTime half_way = *panels.turn_end(SimTime{}) / 2;
  panels.set_stuck(0, true, half_way);
  const std::vector<PanelMiss> misses = panels.misses(half_way);
  ASSERT_EQ(misses.size(), 1u);
  EXPECT_TRUE(misses[0].is_stuck);
  EXPECT_NEAR(misses[0].wanted.elevation_rad, 0.2, 1e-9);
  EXPECT_GT(misses[0].off_rad, 0.1);
  low.is_sun_up = false;
  panels.aim(low, half_way);
  EXPECT_TRUE(panels.misses(half_way).empty());
}

TEST(PanelArray, has_nothing_to_tell_of_panels_that_face_where_they_were_told) {
  PanelArray panels({panel()});
  SimTime now{};
  for (const SteerMode mode : {SteerMode::point, SteerMode::fixed, SteerMode::track}) {
    panels.steer(0, {mode, {-2, 0.7}});
    panels.aim({}, now);
    now += from_seconds(1000);
    EXPECT_TRUE(panels.misses(now).empty());
  }
}

}  // namespace
}  // namespace lsos
