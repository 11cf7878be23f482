// A panel's view of sky and ground, against view factors in closed form.
#include "view/exposure/diffuse_view.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "unit/view/view_fixture.h"

namespace lsos {
namespace {

using test::deg;

using std::numbers::pi;

// A panel whose normal leans away from up by that angle, towards the north.
PanelFace leaning(double lean_rad, double side_m = 1) {
  return {Vec3::Zero(), side_m / 2 * Vec3::UnitX(),
          side_m / 2 * Vec3(0, std::cos(lean_rad), -std::sin(lean_rad))};
}

OpenShares all_open() {
  OpenShares open;
  open.fill(1);
  return open;
}

TerrainHorizon ring(double elevation_rad) {
  TerrainHorizon horizon;
  horizon.elevation_rad.fill(elevation_rad);
  return horizon;
}

class PanelUnderTheSky : public ::testing::Test {
 protected:
  DiffuseView view_of(const PanelFace& panel, const Mesh& solids) {
    return diffuse_view(open_shares(view, panel, solids), panel, {}, {});
  }
  Gpu gpu;
  PanelView view{gpu};
};

// A plane that leans by b sees (1 + cos b) / 2 of an even sky (Liu and Jordan 1963), and the ground
// in the rest.
TEST_F(PanelUnderTheSky, sees_less_of_it_the_more_it_leans) {
  const DiffuseView level = view_of(leaning(0), {});
  EXPECT_NEAR(level.sky, 1, 1e-12);
  EXPECT_NEAR(level.ground, 0, 1e-12);
  for (const double lean_deg : {10., 30., 60., 90., 150., 180.}) {
    const DiffuseView seen = view_of(leaning(lean_deg * deg), {});
    EXPECT_NEAR(seen.sky, (1 + std::cos(lean_deg * deg)) / 2, 0.006) << lean_deg;
    EXPECT_NEAR(seen.sky + seen.ground, 1, 1e-12) << lean_deg;
  }
}

// A ring of mountains of elevation h leaves cos^2 h of the light of an even sky on level ground.
TEST_F(PanelUnderTheSky, loses_what_mountains_hide) {
  for (const double horizon_deg : {2., 10., 30., 60.}) {
    const double h = horizon_deg * deg;
    const DiffuseView seen = diffuse_view(all_open(), leaning(0), ring(h), {});
    EXPECT_NEAR(seen.sky, std::cos(h) * std::cos(h), 0.002) << horizon_deg;
    EXPECT_NEAR(seen.sky + seen.ground, 1, 1e-12);
  }
}

// A plate over the whole panel, parallel to it and as large, has the view factor of two equal
// squares face to face: 0.1998 at a distance of one side (Incropera and DeWitt, table of view
// factors).
TEST_F(PanelUnderTheSky, loses_what_a_plate_above_it_hides) {
  Mesh plate;
  append(plate, box_mesh({1, 1, 0.001}), Mat3::Identity(), {0, 0, 1});
  const DiffuseView seen = view_of(leaning(0), plate);
  EXPECT_NEAR(seen.sky, 1 - 0.1998, 0.02);
  EXPECT_NEAR(seen.ground, 0, 1e-12);
}

// An endless wall along one edge of a narrow strip hides half of its sky where the strip begins.
TEST_F(PanelUnderTheSky, loses_half_beside_a_high_wall) {
  Mesh wall;
  append(wall, box_mesh({1000, 0.001, 1000}), Mat3::Identity(), {0, 0.06, 0});
  EXPECT_NEAR(view_of(leaning(0, 0.1), wall).sky, 0.5, 0.03);
}

TEST_F(PanelUnderTheSky, sees_the_same_each_time) {
  Mesh box;
  append(box, box_mesh({0.3, 0.3, 0.6}), Mat3::Identity(), {0.3, 0.1, 0.3});
  const DiffuseView once = view_of(leaning(0.3), box), again = view_of(leaning(0.3), box);
  EXPECT_EQ(once.sky, again.sky);
  EXPECT_EQ(once.ground, again.ground);
  EXPECT_LT(once.sky + once.ground, 0.95);
}

TEST(TerrainHorizon, is_linear_between_its_azimuths_and_goes_round) {
  TerrainHorizon horizon;
  horizon.elevation_rad[0] = 0.4;
  horizon.elevation_rad[31] = 0.2;
  const double step_rad = 2 * pi / TerrainHorizon::azimuths;
  EXPECT_NEAR(horizon.at(0), 0.4, 1e-12);
  EXPECT_NEAR(horizon.at(step_rad / 2), 0.2, 1e-12);
  EXPECT_NEAR(horizon.at(-step_rad / 2), 0.3, 1e-12);
  EXPECT_NEAR(horizon.at(2 * pi - step_rad), 0.2, 1e-12);
}

TEST(TerrainHorizon, of_a_slope_is_the_slope_up_and_level_down) {
  constexpr double slope_rad = 0.2;
  TerrainSpec spec;
  spec.layers = {PlaneSurface{0, slope_rad, pi}};  // down to the south
  const Ground ground(spec, SiteFrame(*find_body("Mars"), {}), 1);
  const TerrainHorizon horizon = terrain_horizon(ground, {0, 0, 0.001});
  EXPECT_NEAR(horizon.at(0), slope_rad, 0.002);
  EXPECT_NEAR(horizon.at(pi / 4), std::atan(std::tan(slope_rad) * std::cos(pi / 4)), 0.002);
  EXPECT_EQ(horizon.at(pi), 0);
}

TEST(TerrainHorizon, of_level_ground_is_level) {
  TerrainSpec spec;
  spec.layers = {PlaneSurface{}};
  const Ground ground(spec, SiteFrame(*find_body("Mars"), {}), 1);
  for (const double rad : terrain_horizon(ground, {0, 0, 1}).elevation_rad) EXPECT_EQ(rad, 0);
}

}  // namespace
}  // namespace lsos
