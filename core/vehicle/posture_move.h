// A change of stance before it is made: how long it takes, or what hinders it.
#pragma once

#include <string>
#include <vector>

#include "vehicle/limb_chain.h"

namespace lsos {

struct PostureMove {
  double least_s = 0;         // time in which no joint turns faster than it can
  std::string slowest_joint;  // the joint that sets it; "" when nothing moves
  std::string hindrance;      // why it is impossible, "" when it is possible
};

// Moves hubs along straight lines from `from_B_m` to `to_B_m`, by limb, beginning with the joints
// at `angles_rad`; joints in `is_fixed` cannot turn. Hubs move only up and down under the chassis,
// since wheels stand on the ground.
PostureMove posture_move(const VehicleConfig& vehicle, const std::vector<Vec3>& from_B_m,
                         const std::vector<Vec3>& to_B_m,
                         const std::vector<std::vector<double>>& angles_rad,
                         const std::vector<std::vector<bool>>& is_fixed);

// Why a limb does not reach its goal: "limb_1 ends 0.12 m from where its wheel would stand; ...".
std::string reach_text(const VehicleConfig& vehicle, const LimbConfig& limb,
                       const LimbChain::Reach& reach, const std::vector<bool>& is_fixed = {});

}  // namespace lsos
