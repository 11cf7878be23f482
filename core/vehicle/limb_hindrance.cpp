#include "vehicle/limb_hindrance.h"

#include <fmt/format.h>

#include <cmath>

#include "vehicle/limb_stance.h"
#include "vehicle/plane_fit.h"

namespace lsos {

namespace {

constexpr double at_end_rad = 1e-3;
constexpr double torque_share = 0.95;  // of a motor's greatest torque, at which it gives way
constexpr double probe_m = 0.01;       // a limb that does not get half as far down is stretched

std::string because(const std::string& hindrance) {
  return hindrance.empty() ? "" : ": " + hindrance;
}

// How much higher a limb holds its hub than the plane through the hubs of the others, measured from
// their places in the stance.
double above_others_m(const std::vector<Vec3>& hubs_B_m, const std::vector<Vec3>& wanted_B_m,
                      std::size_t limb) {
  const auto raised = [&](std::size_t i) {
    return Vec3(wanted_B_m[i].x(), wanted_B_m[i].y(), hubs_B_m[i].z() - wanted_B_m[i].z());
  };
  std::vector<Vec3> others;
  for (std::size_t i = 0; i < hubs_B_m.size(); ++i) {
    if (i != limb) others.push_back(raised(i));
  }
  if (others.size() < 3) return 0;
  const PlaneFit plane = fit_plane(others, Vec3::UnitZ());
  return (raised(limb) - plane.point).dot(plane.normal) / plane.normal.z();
}

}  // namespace

std::string limb_hindrance(const Vehicle& vehicle, std::size_t limb) {
  const LimbConfig& config = vehicle.config().limbs[limb];
  const std::vector<double> set_rad = vehicle.limb_angles_rad()[limb];
  const std::vector<double> real_rad = vehicle.limb_positions_rad()[limb];
  const std::vector<bool> is_locked = vehicle.limbs_locked()[limb];
  const auto link = [&](std::size_t j) -> const LinkConfig& {
    return vehicle.config().links[static_cast<std::size_t>(config.joints[j])];
  };
  for (std::size_t j = 0; j < set_rad.size(); ++j) {
    if (is_locked[j]) return fmt::format("{} is locked", link(j).name);
  }
  for (std::size_t j = 0; j < set_rad.size(); ++j) {
    const LimbActuator& actuator = *link(j).limb;
    if (set_rad[j] <= actuator.angle_min_rad + at_end_rad ||
        set_rad[j] >= actuator.angle_max_rad - at_end_rad) {
      return fmt::format("{} is at the end of its range, {:.3g} rad ({:.3g}..{:.3g})", link(j).name,
                         set_rad[j], actuator.angle_min_rad, actuator.angle_max_rad);
    }
    const LimbMotor& motor = actuator.motor;
    if (std::abs(set_rad[j] - real_rad[j]) * motor.stiffness_n_m_prad >
        torque_share * motor.torque_max_n_m) {
      return fmt::format("the motor of {} gives no more than {:.4g} N m", link(j).name,
                         motor.torque_max_n_m);
    }
  }
  const LimbChain& chain = vehicle.posture()->chains()[limb];
  std::vector<double> further_rad = chain.step_rad(set_rad, -probe_m * Vec3::UnitZ(), is_locked);
  for (std::size_t j = 0; j < set_rad.size(); ++j) further_rad[j] += set_rad[j];
  const double down_m = chain.pose(set_rad).hub_B_m.z() - chain.pose(further_rad).hub_B_m.z();
  return down_m < probe_m / 2 ? fmt::format("{} is stretched out", config.name) : "";
}

std::string limbs_hindrance(const Vehicle& vehicle) {
  for (std::size_t i = 0; i < vehicle.config().limbs.size(); ++i) {
    std::string hindrance = limb_hindrance(vehicle, i);
    if (!hindrance.empty()) return hindrance;
  }
  return "";
}

std::string stance_fault(const Vehicle& vehicle) {
  if (vehicle.posture() == nullptr || vehicle.is_adjusting()) return "";
  const VehicleConfig& config = vehicle.config();
  const std::vector<Vec3>& wanted_B_m = vehicle.posture()->target_hubs_B_m();
  const std::vector<Vec3> hubs_B_m = vehicle.hubs_B_m();
  const double real_m = height_m(config, hubs_B_m), wanted_m = height_m(config, wanted_B_m);
  if (std::abs(real_m - wanted_m) > stance_within_m) {
    return fmt::format("its chassis is {:.2f} m over the ground instead of {:.2f} m{}", real_m,
                       wanted_m, because(limbs_hindrance(vehicle)));
  }
  for (std::size_t i = 0; i < hubs_B_m.size(); ++i) {
    const std::string hindrance = limb_hindrance(vehicle, i);
    const double aside_m = (hubs_B_m[i] - wanted_B_m[i]).head<2>().norm();
    if (aside_m > stance_within_m) {
      return fmt::format("{} holds its wheel {:.2f} m aside{}", config.limbs[i].name, aside_m,
                         because(hindrance));
    }
    // Uneven ground holds wheels higher and lower too.
    if (hindrance.empty()) continue;
    const double above_m = above_others_m(hubs_B_m, wanted_B_m, i);
    if (std::abs(above_m) > stance_within_m) {
      return fmt::format("{} holds its wheel {:.2f} m {} than the others theirs: {}",
                         config.limbs[i].name, std::abs(above_m), above_m > 0 ? "higher" : "lower",
                         hindrance);
    }
  }
  return "";
}

}  // namespace lsos
