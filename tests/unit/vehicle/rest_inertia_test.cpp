#include "vehicle/suspension/rest_inertia.h"

#include <gtest/gtest.h>

#include "test_rovers.h"

namespace lsos {
namespace {

// A body that carries one link, both floating free.
VehicleConfig pair(JointType joint) {
  VehicleConfig vehicle;
  vehicle.chassis = {10, {1, 2, 3}};
  LinkConfig link;
  link.joint = joint;
  link.axis = Vec3::UnitY();
  link.inertia = {4, {0.5, 0.7, 0.9}};
  vehicle.links.push_back(link);
  return vehicle;
}

TEST(RestInertia, of_a_slide_is_the_reduced_mass) {
  EXPECT_NEAR(RestInertia(pair(JointType::prismatic)).of_joint(0), 10.0 * 4 / 14, 1e-12);
}

TEST(RestInertia, of_a_hinge_through_both_centres_is_the_reduced_moment) {
  EXPECT_NEAR(RestInertia(pair(JointType::revolute)).of_joint(0), 2 * 0.7 / 2.7, 1e-12);
}

TEST(RestInertia, of_a_hinge_beside_the_link_counts_its_arm) {
  // A heavy body hardly moves, so the joint sees I + m r^2.
  VehicleConfig vehicle = pair(JointType::revolute);
  vehicle.chassis = {1e9, {1e9, 1e9, 1e9}};
  vehicle.links[0].p_JC_m = {0, 0, 0.3};
  EXPECT_NEAR(RestInertia(vehicle).of_joint(0), 0.7 + 4 * 0.09, 1e-6);
}

TEST(RestInertia, of_a_rim_is_a_third_of_the_disc) {
  // A free disc pushed along at its rim: 1/m + r^2/(m r^2/2) = 3/m.
  VehicleConfig vehicle;
  vehicle.chassis = {6, {1, 6 * 0.25 / 2, 1}};
  EXPECT_NEAR(RestInertia(vehicle).of_point(-1, {0, 0, -0.5}, Vec3::UnitX()), 2, 1e-12);
  EXPECT_NEAR(RestInertia(vehicle).of_point(-1, {0, 0, -0.5}, Vec3::UnitZ()), 6, 1e-12);
}

TEST(RestInertia, of_a_differential_moves_both_rockers_against_the_body) {
  // Rockers on the body's own axis: 1/I + 1/I + 2^2/I_body.
  VehicleConfig vehicle = pair(JointType::revolute);
  vehicle.links.push_back(vehicle.links[0]);
  EXPECT_NEAR(RestInertia(vehicle).of_coupling({0, 1, 1, 0}), 1 / (2 / 0.7 + 4 / 2.0), 1e-12);
}

TEST(RestInertia, of_a_whole_rover_lifted_at_its_chassis_is_its_mass) {
  VehicleConfig vehicle = test::small_body();
  add_skid_steer(vehicle, test::skid_steer());
  // A force above the centre of mass turns nothing.
  EXPECT_NEAR(RestInertia(vehicle).of_point(-1, {120 * 0.05 / 128, 0, 1}, Vec3::UnitZ()), 128,
              1e-9);
}

// A wheel that its brake holds on a body of no weight to speak of against it.
TEST(RestInertia, the_stiffest_mode_counts_brakes) {
  VehicleConfig vehicle = pair(JointType::revolute);
  vehicle.links[0].drive = DriveMotor{};
  vehicle.links[0].drive->brake_stiffness_n_m_prad = 900;
  const double moment_kgm2 = RestInertia(vehicle).of_joint(0);
  EXPECT_NEAR(RestInertia(vehicle).stiffest_mode_radps(), std::sqrt(900 / moment_kgm2), 1e-6);
}

}  // namespace
}  // namespace lsos
