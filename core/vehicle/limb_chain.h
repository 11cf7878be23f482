// Kinematics of one limb: a chain of revolute joints from the chassis to the hub of a wheel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vehicle/vehicle_config.h"

namespace lsos {

// Where a limb holds its wheel.
struct LimbPose {
  Vec3 hub_B_m = Vec3::Zero();
  Vec3 up_B = Vec3::UnitZ();  // direction of the wheel's steering axis
};

class LimbChain {
 public:
  LimbChain(const VehicleConfig& vehicle, const LimbConfig& limb);

  std::size_t size() const { return joints_.size(); }
  const LimbPose& at_rest() const { return at_rest_; }

  // `angles_rad` in all that follows: by joint, counted from rest, outwards.
  LimbPose pose(const std::vector<double>& angles_rad) const;

  // Change of the angles that moves the hub by `hub_B_m` and turns the steering axis towards the
  // chassis' z axis, to first order (damped least squares, Wampler 1986). The hub goes before the
  // axis where a chain has too few joints for both. Joints in `is_fixed` do not turn.
  std::vector<double> step_rad(const std::vector<double>& angles_rad, const Vec3& hub_B_m,
                               const std::vector<bool>& is_fixed) const;

  struct Reach {
    std::vector<double> angles_rad;
    double error_m = 0;       // distance that is left between hub and goal
    double lean_rad = 0;      // of the steering axis, from the chassis' z axis
    int limiting_joint = -1;  // a joint that stands at an end of its range; -1: none
    // The hub is at its goal, and the wheel stands as upright as the chain can hold it.
    bool is_there = false;
  };
  // Angles within the joints' ranges that bring the hub to `hub_B_m`, found from `from_rad` on.
  Reach reach(const Vec3& hub_B_m, std::vector<double> from_rad,
              const std::vector<bool>& is_fixed = {}) const;

 private:
  struct Joint {
    Vec3 p_B_m = Vec3::Zero();  // at rest
    Vec3 axis_B = Vec3::UnitZ();
    double angle_min_rad = 0, angle_max_rad = 0;
  };

  // Whether it has the joints to hold a hub in its place and the wheel upright there; a chain of
  // fewer leans its wheel whenever it moves.
  bool can_hold_upright() const { return joints_.size() >= 5; }

  std::vector<Joint> joints_;
  LimbPose at_rest_;
};

// The chains of all limbs.
std::vector<LimbChain> limb_chains(const VehicleConfig& vehicle);

// Distance from its goal at which a hub counts as there.
inline constexpr double hub_reached_m = 1e-3;
// Lean at which a wheel counts as upright, 3 degrees.
inline constexpr double upright_within_rad = 0.05;

}  // namespace lsos
