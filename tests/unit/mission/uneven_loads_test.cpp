// Loads of wheels on rough ground.
#include "mission/routes/uneven_loads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lsos {
namespace {

constexpr double g_mps2 = 1.62, stiffness_npm = 5e4;

// A chassis without springs on four wheels, 2 m by 1 m apart.
VehicleConfig cart() {
  VehicleConfig cart;
  cart.chassis.mass_kg = 400;
  for (int k = 0; k < 4; ++k) {
    LinkConfig link;
    link.wheel = Wheel{};
    link.wheel->radius_m = 0.3;
    link.wheel->normal_stiffness_npm = stiffness_npm;
    cart.links.push_back(link);
  }
  return cart;
}
const std::vector<Vec2> corners_m{{1, 0.5}, {1, -0.5}, {-1, 0.5}, {-1, -0.5}};

double load_1pm(const VehicleConfig& vehicle, const std::vector<Vec2>& wheels_B_m = corners_m) {
  DriveCost cost;
  cost.gravity_mps2 = g_mps2;
  cost.wheels_B_m = wheels_B_m;
  return uneven_load_1pm(vehicle, cost);
}

// Distances from the plane are normally distributed: their standard deviation is sqrt(pi / 2) of
// their mean.
const double deviation = std::sqrt(std::numbers::pi / 2);

TEST(UnevenLoads, of_wheels_without_springs_follow_from_their_own_stiffness) {
  const double load_n = 100 * g_mps2;
  EXPECT_NEAR(load_1pm(cart()), deviation * stiffness_npm / load_n, 1e-9);
}

TEST(UnevenLoads, are_softened_by_springs) {
  VehicleConfig sprung;
  sprung.chassis.mass_kg = 400;
  for (int k = 0; k < 4; ++k) {
    LinkConfig arm;
    arm.joint = JointType::prismatic;
    arm.spring = SpringDamper{.stiffness = 2000};
    sprung.links.push_back(arm);
    LinkConfig wheel = cart().links[0];
    wheel.parent = 2 * k;
    sprung.links.push_back(wheel);
  }
  const double both_npm = 1 / (1 / 2000.0 + 1 / stiffness_npm), load_n = 100 * g_mps2;
  EXPECT_NEAR(load_1pm(sprung), deviation * both_npm / load_n, 1e-9);
}

// A link that turns freely, as a bogie does, keeps the loads of its wheels even.
TEST(UnevenLoads, are_none_on_free_joints) {
  VehicleConfig bogie = cart();
  bogie.links.insert(bogie.links.begin(), 2, LinkConfig{});  // left and right
  for (const std::size_t k : {2u, 3u, 4u, 5u}) bogie.links[k].parent = k % 2 == 0 ? 0 : 1;
  EXPECT_EQ(load_1pm(bogie), 0);
}

// Three places always lie on a plane, whatever the ground.
TEST(UnevenLoads, do_not_follow_from_the_roughness_under_three_wheels) {
  VehicleConfig three = cart();
  three.links.pop_back();
  EXPECT_EQ(load_1pm(three, {{1.234, 0.5}, {1.1, -0.517}, {-1, 0.013}}), 0);
}

}  // namespace
}  // namespace lsos
