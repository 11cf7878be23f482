#include "vehicle/single_wheel.h"

#include <cmath>

namespace lsos {

namespace {

constexpr double speed_mps =
    0.1;  // the faster of rolling and travel speed; forces do not depend on it
constexpr double step_s = 0.2;
constexpr int settling_steps_max = 100'000, steady_steps = 10;
constexpr double steady = 1e-12;  // relative change of the sinkage in one step

}  // namespace

double slip_by(double radius_m, double slip, double slip_radius_m) {
  const double travel = slip > 0 ? 1 - slip : 1;
  const double rolling = (slip < 0 ? 1 + slip : 1) * radius_m / slip_radius_m;
  return rolling >= travel ? 1 - travel / rolling : rolling / travel - 1;
}

SingleWheelPoint single_wheel(const WheelSoil& wheel_soil, double load_n, double slip,
                              double slip_angle_rad) {
  SingleWheelPoint point;
  point.slip = slip;
  point.slip_angle_rad = slip_angle_rad;
  const double travel_mps = slip > 0 ? speed_mps * (1 - slip) : speed_mps;

  WheelContactInput input;
  input.load_n = load_n;
  input.normal_S = Vec3::UnitZ();
  input.heading_S = Vec3::UnitX();
  input.hub_velocity_S_mps =
      travel_mps * Vec3(std::cos(slip_angle_rad), std::sin(slip_angle_rad), 0);
  const double rolling_mps = slip < 0 ? speed_mps * (1 + slip) : speed_mps;
  input.rim_speed_mps =
      rolling_mps * wheel_soil.shear_radius_m() / wheel_soil.rolling_radius_m(load_n);

  // A wheel at full slip has been rolling before: the resistance of the soil ahead is built up.
  WheelContactState state;
  state.rolled_m = rolling_mobilised_m;
  WheelContactForces forces;
  for (int i = 0, unchanged = 0; i < settling_steps_max && unchanged < steady_steps; ++i) {
    const Vec3 before_S_m = state.shear_S_m;
    const double before_m = state.sinkage_m, rolled_m = state.rolled_m;
    forces = wheel_soil.forces(input, step_s, state);
    const bool is_steady = std::abs(state.sinkage_m - before_m) <= steady * state.sinkage_m &&
                           (state.shear_S_m - before_S_m).norm() <= steady &&
                           state.rolled_m == rolled_m;
    unchanged = is_steady ? unchanged + 1 : 0;
  }
  const Vec3 force_n = forces.traction_S_n + forces.hub_force_S_n;
  point.drawbar_pull_n = force_n.x();
  point.side_force_n = force_n.y();
  point.torque_n_m = forces.traction_S_n.x() * forces.arm_m;
  point.sinkage_m = forces.sinkage_m;
  point.traction_limit_n = forces.soil_shear_n;
  return point;
}

}  // namespace lsos
