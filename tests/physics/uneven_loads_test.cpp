// Loads of SEV's twin wheels on rough ground, by the heights of the ground under each of them.
#include "mission/routes/drive_cost_model.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "mission/model/site.h"
#include "physics/drive.h"
#include "planet/ellipsoid.h"
#include "route/cost/stance_drive.h"
#include "vehicle/part_pose.h"

namespace lsos::test {
namespace {

constexpr int places = 400;
constexpr double apart_m = 7, spring_npm = 1e4, tyre_npm = 1e5;  // of SEV's script

TEST(UnevenLoads, are_what_heights_under_the_wheels_make_them) {
  Detail detail;
  detail.roughness = Roughness{0.02, 0.7};
  const auto rough = ground({"Moon", PlaneSurface{}, "ApolloNominal", detail});
  const VehicleConfig rover = rover_on("SEV", *rough, "Moon");
  const double g_mps2 = gravity_mps2(*find_body("Moon"), start);
  std::vector<Vec2> wheels_B_m;
  const std::vector<Vec3> centres_B_m = centres_at_rest_B_m(rover);
  for (std::size_t i = 0; i < rover.links.size(); ++i) {
    if (rover.links[i].wheel) wheels_B_m.push_back(centres_B_m[i + 1].head<2>());
  }
  const std::size_t axles = wheels_B_m.size() / 2;
  Eigen::MatrixXd plane(axles, 3);
  for (std::size_t a = 0; a < axles; ++a) {
    const Vec2 at_m = (wheels_B_m[2 * a] + wheels_B_m[2 * a + 1]) / 2;
    plane.row(static_cast<Eigen::Index>(a)) << 1, at_m.x(), at_m.y();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> fit(plane);

  const auto height_m = [&](const Vec2& at_m) {
    return *rough->elevation_m(rough->site().geodetic({at_m.x(), at_m.y(), 0}));
  };
  const double axle_npm = 1 / (1 / spring_npm + 1 / (2 * tyre_npm));
  double off_sum_m = 0, load_sum_n2 = 0;
  for (int k = 0; k < places; ++k) {
    const Vec2 at_m = apart_m * Vec2(k % 20, k / 20);
    Eigen::VectorXd mean_m(axles);
    for (std::size_t a = 0; a < axles; ++a) {
      const double left_m = height_m(at_m + wheels_B_m[2 * a]);
      const double right_m = height_m(at_m + wheels_B_m[2 * a + 1]);
      mean_m[static_cast<Eigen::Index>(a)] = (left_m + right_m) / 2;
      const double twist_n = tyre_npm * (left_m - right_m) / 2;
      load_sum_n2 += twist_n * twist_n / static_cast<double>(axles);
    }
    const Eigen::VectorXd off_m = mean_m - plane * fit.solve(mean_m);
    off_sum_m += off_m.cwiseAbs().mean();
    load_sum_n2 += (axle_npm * off_m / 2).squaredNorm() / static_cast<double>(axles);
  }
  const double load_n = rover.mass_kg() * g_mps2 / static_cast<double>(wheels_B_m.size());
  const double by_heights = std::sqrt(load_sum_n2 / places) / load_n / (off_sum_m / places);
  const double formula =
      drive_cost(rover, rough->soils(), g_mps2, rover.cruise_speed_mps).uneven_1pm;
  EXPECT_NEAR(formula / by_heights, 1, 0.15);
  RecordProperty("formula_to_heights", fmt::format("{:.3f}", formula / by_heights));
}

class UnevenLoadsOf : public testing::TestWithParam<const char*> {};

// Also on ground far rougher, and slopes far steeper, than planning allows.
TEST_P(UnevenLoadsOf, never_make_a_drive_cheaper_nor_endless) {
  for (const auto& [planet, soil] : {std::pair("Moon", "ApolloNominal"),
                                     {"Moon", "ApolloLoose"},
                                     {"Earth", "SandyLoam"},
                                     {"Earth", "DrySandLoose"},
                                     {"Mars", "MMS"}}) {
    const auto level = ground({planet, PlaneSurface{}, "ApolloNominal"});
    const VehicleConfig rover = rover_on(GetParam(), *level, planet);
    const double g_mps2 = gravity_mps2(*find_body(planet), start);
    const DriveCost cost = drive_cost(rover, {shipped_soil(soil)}, g_mps2, rover.cruise_speed_mps);
    if (cost.soils.front().by_slope.empty()) continue;
    for (double pitch_rad = -0.6; pitch_rad < 0.6; pitch_rad += 0.05) {
      Stance stance;
      stance.is_on_ground = true;
      stance.pitch_rad = pitch_rad;
      stance.slope_rad = std::abs(pitch_rad);
      const SlopeDrive even = stance_drive(cost, stance);
      for (const double roughness_m : {0.001, 0.01, 0.1, 1.0}) {
        stance.roughness_m = roughness_m;
        const SlopeDrive drive = stance_drive(cost, stance);
        const std::string at =
            fmt::format("{} {} {:.2f} rad, {} m", planet, soil, pitch_rad, roughness_m);
        EXPECT_GT(drive.speed_mps, 0) << at;
        EXPECT_LE(drive.speed_mps, even.speed_mps * (1 + 1e-9)) << at;
        EXPECT_GE(drive.energy_jpm, even.energy_jpm * (1 - 1e-9)) << at;
        EXPECT_LT(drive.slip, 1) << at;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rovers, UnevenLoadsOf,
                         testing::Values("SEV", "LRV", "MER", "MSL", "VIPER", "Husky", "ATHLETE",
                                         "Rashid"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace lsos::test
