#include "vehicle/multibody.h"

#include <gtest/gtest.h>

#include "test_rover.h"

namespace lsos {
namespace {

constexpr double gravity_mps2 = 1.625;

Vec3 momentum(const Multibody& bodies, const VehicleConfig& config) {
  Vec3 p = config.chassis.mass_kg * bodies.motion(Multibody::chassis).v_C_S_mps;
  for (std::size_t i = 0; i < config.links.size(); ++i) {
    p += config.links[i].inertia.mass_kg * bodies.motion(static_cast<int>(i)).v_C_S_mps;
  }
  return p;
}

TEST(Multibody, falls_freely_as_a_stone_does) {
  const VehicleConfig config = test::rover(gravity_mps2);
  Multibody bodies(config);
  bodies.place({0, 0, 100}, Mat3::Identity());
  constexpr double step_s = 0.001;
  for (int i = 0; i < 2000; ++i) {
    bodies.add_gravity({0, 0, -gravity_mps2});
    bodies.step(step_s);
  }
  const LinkMotion& chassis = bodies.motion(Multibody::chassis);
  EXPECT_NEAR(chassis.v_C_S_mps.z(), -gravity_mps2 * 2, 1e-9);
  // Semi-implicit steps fall farther than g t^2 / 2 by g t dt / 2.
  EXPECT_NEAR(chassis.p_C_S_m.z(), 101.2 - gravity_mps2 * 2 - gravity_mps2 * 2 * step_s / 2, 1e-9);
  for (std::size_t i = 0; i < config.links.size(); ++i) {
    EXPECT_NEAR(bodies.joint_velocity(static_cast<int>(i)), 0, 1e-9);
  }
}

TEST(Multibody, keeps_momentum_in_free_flight_while_its_motors_turn) {
  const VehicleConfig config = test::rover(gravity_mps2);
  Multibody bodies(config);
  bodies.place({0, 0, 100}, Mat3::Identity());
  for (int i = 0; i < 500; ++i) {
    for (std::size_t link = 0; link < config.links.size(); ++link) {
      const int index = static_cast<int>(link);
      if (config.links[link].wheel) bodies.add_joint_force(index, 20);
      if (config.links[link].spring)
        bodies.add_joint_force(index, 100 - 1e4 * bodies.joint_position(index));
    }
    bodies.step(0.001);
  }
  EXPECT_GT(bodies.joint_velocity(2), 1);
  // Motors and springs act between links only: total momentum stays zero.
  EXPECT_LT(momentum(bodies, config).norm(), 1e-3 * config.mass_kg() * 0.1);
}

TEST(Multibody, link_velocities_are_the_rates_of_link_positions) {
  const VehicleConfig config = test::rover(gravity_mps2);
  Multibody bodies(config);
  bodies.place({1, 2, 3}, Quat(0.9, 0.1, -0.2, 0.3).normalized().toRotationMatrix());
  for (int i = 0; i < 50; ++i) {
    for (int link = 0; link < 24; ++link) bodies.add_joint_force(link, link % 4 == 0 ? 50 : 5);
    bodies.step(1e-3);
  }
  std::vector<Vec3> before;
  for (int link = -1; link < 24; ++link) before.push_back(bodies.motion(link).p_C_S_m);
  bodies.step(1e-7);
  for (int link = -1; link < 24; ++link) {
    const Vec3 rate =
        (bodies.motion(link).p_C_S_m - before[static_cast<std::size_t>(link + 1)]) / 1e-7;
    EXPECT_LT((rate - bodies.motion(link).v_C_S_mps).norm(), 1e-6) << "link " << link;
  }
}

TEST(Multibody, goes_on_bit_for_bit_from_saved_state) {
  const VehicleConfig config = test::rover(gravity_mps2);
  Multibody first(config);
  first.place({0, 0, 10}, Mat3::Identity());
  const auto drive = [](Multibody& bodies) {
    for (int i = 0; i < 300; ++i) {
      for (int link = 0; link < 24; ++link) bodies.add_joint_force(link, 0.5 * (link - i % 7));
      bodies.add_gravity({0.1, 0, -gravity_mps2});
      bodies.step(0.002);
    }
  };
  drive(first);
  Archive saved = Archive::writer();
  first.archive(saved);
  Multibody second(config);
  Archive reader = Archive::reader(saved.bytes());
  second.archive(reader);
  drive(first);
  drive(second);
  Archive a = Archive::writer(), b = Archive::writer();
  first.archive(a);
  second.archive(b);
  EXPECT_EQ(a.bytes(), b.bytes());
}

}  // namespace
}  // namespace lsos
