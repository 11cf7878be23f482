// A six-module rover with round numbers, and grounds to stand it on.
#pragma once

#include <memory>

#include "terrain/ground.h"
#include "vehicle/suspension/wishbone.h"

namespace lsos::test {

inline Soil soil() {
  return {.name = "ApolloNominal",
          .k_c = 1400,
          .k_phi = 820000,
          .n = 1,
          .cohesion_pa = 170,
          .friction_rad = 0.6108652381980153,
          .density_kgpm3 = 1520,
          .shear_modulus_x_m = 0.018,
          .shear_modulus_y_m = 0.018};
}

inline Wishbone suspension() {
  Wishbone w;
  for (const double x : {2.0, 0.0, -2.0}) {
    for (const double y : {1.5, -1.5}) {
      w.modules.push_back({(x > 0   ? "front"
                            : x < 0 ? "rear"
                                    : "middle") +
                               std::string(y > 0 ? "_left" : "_right"),
                           Vec2(x, y)});
    }
  }
  w.arm_mass_kg = 40;
  w.knuckle_mass_kg = 40;
  w.stiffness_npm = 1e4;
  w.damping_nspm = 3e3;
  w.travel_up_m = w.travel_down_m = 0.25;
  w.steering = {.angle_max_rad = 3.2,
                .rate_max_radps = 0.6,
                .torque_max_n_m = 2000,
                .stiffness_n_m_prad = 2e4,
                .damping_n_m_sprad = 1e3};
  w.wheel_offsets_m = {0.25, -0.25};
  w.wheel_mass_kg = 30;
  w.wheel = {.radius_m = 0.5,
             .width_m = 0.3,
             .normal_stiffness_npm = 1e5,
             .normal_damping_nspm = 1e3,
             .tangential_damping_nspm = 500};
  w.drive = {.torque_max_n_m = 800,
             .power_max_w = 2000,
             .efficiency = 0.8,
             .servo_gain_n_m_sprad = 300,
             .servo_integral_n_m_prad = 300,
             .brake_torque_max_n_m = 1500,
             .brake_stiffness_n_m_prad = 2e4,
             .brake_damping_n_m_sprad = 200};
  return w;
}

inline VehicleConfig rover(double gravity_mps2) {
  VehicleConfig v;
  v.type = "Test";
  v.chassis = {3000, {4000, 6000, 8000}};
  v.p_BC_m = {0, 0, 1.2};
  v.chassis_size_m = {4, 2.5, 2};
  v.chassis_clearance_m = 0.5;
  v.cruise_speed_mps = 2;
  v.speed_max_mps = 3;
  v.acceleration_mps2 = 0.3;
  v.can_turn_on_spot = true;
  add_wishbone(v, suspension(), gravity_mps2);
  return v;
}

// Ground at the Moon's equator, tilted down towards the azimuth.
inline std::unique_ptr<Ground> moon(double slope_rad = 0, double downslope_azimuth_rad = 0) {
  TerrainSpec spec;
  spec.name = "Test";
  spec.layers = {PlaneSurface{0, slope_rad, downslope_azimuth_rad}};
  spec.soil = soil();
  return std::make_unique<Ground>(spec, SiteFrame(*find_body("Moon"), {0.1, 0.2, 0}), 0);
}

}  // namespace lsos::test
