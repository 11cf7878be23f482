#include "vehicle/posture_move.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace lsos {

namespace {

constexpr int parts = 20;             // into which a line is divided
constexpr double tie = 1e-6;          // limbs alike need times alike: the first is named
constexpr double aside_max_m = 0.05;  // a hub may stray so far from above its wheel's place

const LinkConfig& joint_of(const VehicleConfig& vehicle, const LimbConfig& limb, std::size_t j) {
  return vehicle.links[static_cast<std::size_t>(limb.joints[j])];
}

}  // namespace

std::string reach_text(const VehicleConfig& vehicle, const LimbConfig& limb,
                       const LimbChain::Reach& reach, const std::vector<bool>& is_fixed) {
  std::string text = reach.error_m > hub_reached_m
                         ? fmt::format("{} ends {:.2g} m from where its wheel would stand",
                                       limb.name, reach.error_m)
                         : fmt::format("the wheel of {} would lean by {:.0f} deg", limb.name,
                                       degrees(reach.lean_rad));
  for (std::size_t j = 0; j < is_fixed.size(); ++j) {
    if (is_fixed[j]) return text + fmt::format("; {} is locked", joint_of(vehicle, limb, j).name);
  }
  if (reach.limiting_joint < 0) return text + ": it is too short";
  const auto limiting = static_cast<std::size_t>(reach.limiting_joint);
  const LinkConfig& joint = joint_of(vehicle, limb, limiting);
  return text + fmt::format("; {} is at the end of its range, {:.3g} rad ({:.3g}..{:.3g})",
                            joint.name, reach.angles_rad[limiting], joint.limb->angle_min_rad,
                            joint.limb->angle_max_rad);
}

PostureMove posture_move(const VehicleConfig& vehicle, const std::vector<Vec3>& from_B_m,
                         const std::vector<Vec3>& to_B_m,
                         const std::vector<std::vector<double>>& angles_rad,
                         const std::vector<std::vector<bool>>& is_fixed) {
  PostureMove move;
  for (std::size_t i = 0; i < vehicle.limbs.size(); ++i) {
    const LimbConfig& limb = vehicle.limbs[i];
    if ((to_B_m[i] - from_B_m[i]).head<2>().norm() > aside_max_m) {
      move.hindrance = fmt::format(
          "the wheel of {} stands {:.2f} m from where it would be, and wheels are not moved aside",
          limb.name, (to_B_m[i] - from_B_m[i]).head<2>().norm());
      return move;
    }
    if ((to_B_m[i] - from_B_m[i]).norm() <= hub_reached_m) continue;
    const LimbChain chain(vehicle, limb);
    std::vector<double> before_rad =
        chain.reach(from_B_m[i], angles_rad[i], is_fixed[i]).angles_rad;
    for (int part = 1; part <= parts; ++part) {
      const Vec3 goal_B_m = from_B_m[i] + (to_B_m[i] - from_B_m[i]) * part / parts;
      const LimbChain::Reach reach = chain.reach(goal_B_m, before_rad, is_fixed[i]);
      if (!reach.is_there) {
        move.hindrance = reach_text(vehicle, limb, reach, is_fixed[i]);
        return move;
      }
      for (std::size_t j = 0; j < before_rad.size(); ++j) {
        const LinkConfig& joint = joint_of(vehicle, limb, j);
        const double time_s = parts * std::abs(reach.angles_rad[j] - before_rad[j]) /
                              joint.limb->motor.rate_max_radps;
        if (time_s <= move.least_s * (1 + tie)) continue;
        move.least_s = time_s;
        move.slowest_joint = joint.name;
      }
      before_rad = reach.angles_rad;
    }
  }
  return move;
}

}  // namespace lsos
