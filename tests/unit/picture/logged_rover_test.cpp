// Interpolation of rovers between two samples of a log.
#include "picture/logged_rover.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace lsos {
namespace {

constexpr double deg = std::numbers::pi / 180;

struct Moon {
  SiteFrame site{*find_body("Moon"), geodetic_from_degrees(30, 10)};

  LoggedRover rover(double x_m, double heading_deg, double pitch_deg, double roll_deg) const {
    LoggedRover rover;
    rover.sample.p_S_m = {x_m, 0, 0};
    rover.sample.heading_rad = heading_deg * deg;
    rover.sample.pitch_rad = pitch_deg * deg;
    rover.sample.roll_rad = roll_deg * deg;
    return rover;
  }
};

TEST(LoggedRover, between_two_samples_is_on_the_way_and_turns_the_short_way) {
  const Moon moon;
  LoggedRover from = moon.rover(0, 350, 4, -2), to = moon.rover(8, 20, 4, -2);
  from.joints = {{{}, "R", "wheel", 1, not_modelled}, {{}, "R", "slide", not_modelled, 0.1}};
  to.joints = {{{}, "R", "slide", not_modelled, 0.3}, {{}, "R", "wheel", 21, not_modelled}};
  const LoggedRover mid = between(moon.site, from, to, 0.5);
  EXPECT_NEAR(mid.sample.p_S_m.x(), 4, 1e-12);
  EXPECT_NEAR(mid.sample.heading_rad, 5 * deg, 1e-3 * deg);
  EXPECT_NEAR(mid.sample.pitch_rad, 4 * deg, 0.2 * deg);
  EXPECT_NEAR(mid.sample.roll_rad, -2 * deg, 0.2 * deg);
  EXPECT_NEAR(mid.joints[0].angle_rad, 11, 1e-12);
  EXPECT_NEAR(mid.joints[1].extension_m, 0.2, 1e-12);
  // The place is 4 m east of 30 degrees east, 10 degrees north.
  EXPECT_NEAR(mid.sample.place.lon_rad / deg, 30 + 4 / (1737400 * std::cos(10 * deg)) / deg, 1e-9);
}

TEST(LoggedRover, at_either_end_is_what_the_sample_says) {
  const Moon moon;
  const LoggedRover from = moon.rover(0, 100, -7, 12), to = moon.rover(5, 120, 3, -4);
  for (const auto& [share, end] : {std::pair{0.0, &from}, std::pair{1.0, &to}}) {
    const LoggedRover there = between(moon.site, from, to, share);
    EXPECT_LT((there.sample.p_S_m - end->sample.p_S_m).norm(), 1e-12);
    EXPECT_NEAR(there.sample.heading_rad, end->sample.heading_rad, 1e-9);
    EXPECT_NEAR(there.sample.pitch_rad, end->sample.pitch_rad, 1e-9);
    EXPECT_NEAR(there.sample.roll_rad, end->sample.roll_rad, 1e-9);
  }
}

PanelSpec flat_panel() {
  PanelSpec panel;
  panel.name = "Roof";
  panel.length_m = 2;
  panel.width_m = 4;
  panel.azimuth = {-std::numbers::pi, std::numbers::pi};
  panel.elevation = {0, std::numbers::pi / 2};
  panel.rest.elevation_rad = std::numbers::pi / 2;
  return panel;
}

// A panel that lies flat on a rover that pitches to and fro faces opposite azimuths in the log.
TEST(LoggedRover, a_flat_panel_lies_flat_between_samples_too) {
  const Moon moon;
  const std::vector<PanelSpec> panels{flat_panel()};
  LoggedRover from = moon.rover(0, 0, 3, 0), to = moon.rover(0, 0, -3, 0);
  from.panels = {{{}, "R", "Roof", 1, 1, 1, std::numbers::pi, 87 * deg}};
  to.panels = {{{}, "R", "Roof", 1, 1, 1, 0, 87 * deg}};
  const PanelFace level = panel_faces(moon.site, panels, from).at(0).value();
  const LoggedRover mid = between(moon.site, from, to, 0.5);
  const PanelFace face = panel_faces(moon.site, panels, mid).at(0).value();
  EXPECT_NEAR(face.normal().z(), 1, 1e-9);
  // Its sides keep their directions about the rover.
  EXPECT_NEAR(face.half_u_m.normalized().dot(level.half_u_m.normalized()), 1, 0.002);
}

TEST(LoggedRover, a_panel_that_is_folded_in_one_sample_is_as_the_first_has_it) {
  const Moon moon;
  LoggedRover up = moon.rover(0, 0, 0, 0), down = moon.rover(0, 0, 0, 0);
  up.panels = {{{}, "R", "Roof", 1, 1, 1, 0.5, 1.0}};
  down.panels = {
      {{}, "R", "Roof", not_modelled, not_modelled, not_modelled, not_modelled, not_modelled}};
  EXPECT_NEAR(between(moon.site, up, down, 0.5).panels[0].elevation_rad, 1.0, 1e-9);
  EXPECT_TRUE(std::isnan(between(moon.site, down, up, 0.5).panels[0].elevation_rad));
}

TEST(LoggedRover, has_masts_as_far_as_they_were_raised) {
  AntennaSpec mast{.name = "Mast", .p_B_m = {-2, 0, 8}, .stowed_p_B_m = Vec3(-2, 0, 3)};
  AntennaSpec whip{.name = "Whip", .p_B_m = {0, 0, 4}, .stowed_p_B_m = {}};
  LoggedRover rover;
  rover.joints = {{{}, "R", mast_joint(mast), not_modelled, 2}};
  const std::vector<Shape> shapes = masts(std::vector{mast, whip}, rover);
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_LT((shapes[0].p_B_m - Vec3(-2, 0, 4)).norm(), 1e-12);  // the middle of 2 m from 3
  EXPECT_NEAR(shapes[0].size_m.z(), 2, 1e-12);
  EXPECT_LT((shapes[1].p_B_m - Vec3(-2, 0, 5)).norm(), 1e-12);  // its head
}

TEST(AntennaArray, rises_evenly_and_turns_back_from_where_it_is) {
  AntennaSpec mast{
      .name = "Mast", .p_B_m = {0, 0, 8}, .stowed_p_B_m = Vec3(0, 0, 3), .deploy_s = 100};
  AntennaArray array({mast});
  const auto at = [&](double time_s) { return array.extension_m(0, from_seconds(time_s)); };
  EXPECT_EQ(at(0), 0);
  array.deploy("Mast", true, std::nullopt, from_seconds(10));
  EXPECT_NEAR(at(35), 1.25, 1e-9);
  array.deploy("Mast", false, 50.0, from_seconds(60));
  EXPECT_NEAR(at(60), 2.5, 1e-9);
  EXPECT_NEAR(at(85), 1.25, 1e-9);
  EXPECT_EQ(at(110), 0);
}

}  // namespace
}  // namespace lsos
