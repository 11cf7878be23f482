#include "vehicle/suspension/vehicle_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"
#include "vehicle/drive_control.h"
#include "vehicle/suspension/link_parts.h"
#include "vehicle/suspension/rest_inertia.h"

namespace lsos {

namespace {

// A wheel of the vehicle at rest with all joints at 0.
struct StandingWheel {
  const LinkConfig* link;
  Vec3 hub_B_m;
};

std::vector<StandingWheel> standing_wheels(const VehicleConfig& vehicle) {
  std::vector<StandingWheel> wheels;
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    if (!vehicle.links[i].wheel) continue;
    wheels.push_back({&vehicle.links[i], joint_at_rest_B_m(vehicle, static_cast<int>(i))});
  }
  return wheels;
}

// Distance of `p` to the left of the line from a to b, times the length |b - a|.
double left_of(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a, to = p - a;
  return along.x() * to.y() - along.y() * to.x();
}

// Whether p lies in the convex hull of the points: on the inner side of each line through two of
// them that has all others on one side.
bool is_within_hull(const Vec2& p, const std::vector<Vec2>& points) {
  for (const Vec2& a : points) {
    for (const Vec2& b : points) {
      const bool is_edge =
          std::ranges::all_of(points, [&](const Vec2& c) { return left_of(c, a, b) >= 0; });
      if (is_edge && a != b && left_of(p, a, b) <= 0) return false;
    }
  }
  return true;
}

// The height check runs before others since its message names the wheel.
void check_height(const StandingWheel& wheel, double tolerance_m,
                  std::vector<std::string>& faults) {
  const double radius_m = wheel.link->wheel->radius_m;
  const double gap_m = wheel.hub_B_m.z() - radius_m;
  if (std::abs(gap_m) <= tolerance_m) return;
  faults.push_back(fmt::format(
      "{}: its hub is {:.3f} m above the ground at rest and its radius is {} m: it is {:.3f} m {}",
      wheel.link->name, wheel.hub_B_m.z(), radius_m, std::abs(gap_m),
      gap_m < 0 ? "below the ground" : "off the ground"));
}

void check_overlap(const StandingWheel& a, const StandingWheel& b,
                   std::vector<std::string>& faults) {
  const double along_m = std::abs(a.hub_B_m.x() - b.hub_B_m.x());
  const double across_m = std::abs(a.hub_B_m.y() - b.hub_B_m.y());
  const double reach_m = a.link->wheel->radius_m + b.link->wheel->radius_m;
  const double width_m = (a.link->wheel->width_m + b.link->wheel->width_m) / 2;
  if (along_m >= reach_m || across_m >= width_m) return;
  if (a.hub_B_m.y() * b.hub_B_m.y() < 0) {
    faults.push_back(
        fmt::format("{} and {}: the track of {:.3f} m is narrower than a wheel, {:.3f} m",
                    a.link->name, b.link->name, across_m, width_m));
  } else {
    faults.push_back(fmt::format(
        "{} and {} overlap: {:.3f} m apart along and {:.3f} m across; {:.3f} m along or {:.3f} m "
        "across is needed",
        a.link->name, b.link->name, along_m, across_m, reach_m, width_m));
  }
}

// Least angle, either way, by which a steering is turned when its wheel rolls while the vehicle
// turns about `center_B_m`; a wheel may roll in either direction along its heading.
double rolling_angle_rad(const WheelLayout::Steering& steering, const Vec2& center_B_m) {
  const Vec2 arm = steering.p_B_m - center_B_m;
  if (arm.norm() == 0) return 0;
  return std::abs(
      std::remainder(std::atan2(arm.x(), -arm.y()) - steering.heading_rad, std::numbers::pi));
}

}  // namespace

std::vector<std::string> stability_faults(const VehicleConfig& vehicle) {
  const double step_s = seconds(vehicle.step);
  const RestInertia inertia(vehicle);
  std::vector<std::string> faults;
  const auto check_spring = [&](const std::string& name, const char* what, double stiffness,
                                double moved) {
    const double mode = std::sqrt(stiffness / moved) * step_s;
    if (mode > 1) {
      faults.push_back(fmt::format(
          "step_s = {}: too long for the {} of {}: omega x step is {:.2f}, at most 1 is stable; "
          "a step of {:.4f} s or less, or a softer spring",
          step_s, what, name, mode, step_s / mode));
    }
  };
  const auto check_damper = [&](const std::string& name, const char* what, double damping,
                                double moved) {
    const double share = damping / moved * step_s;
    if (share > 1) {
      faults.push_back(fmt::format(
          "step_s = {}: too long for the {} of {}: damping x step / inertia is {:.2f}, at most 1 "
          "is stable; a step of {:.4f} s or less, or {:.4g} of damping",
          step_s, what, name, share, step_s / share, damping / share));
    }
  };
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    const LinkConfig& link = vehicle.links[i];
    const int index = static_cast<int>(i);
    const double joint = inertia.of_joint(index);
    if (const auto& wheel = link.wheel) {
      const Vec3 contact_B_m = joint_at_rest_B_m(vehicle, index) - wheel->radius_m * Vec3::UnitZ();
      const auto at_contact = [&](const Vec3& direction) {
        return inertia.of_point(index, contact_B_m, direction);
      };
      check_spring(link.name, "wheel's normal spring", wheel->normal_stiffness_npm,
                   link.inertia.mass_kg);
      check_damper(link.name, "wheel's normal damper", wheel->normal_damping_nspm,
                   at_contact(Vec3::UnitZ()));
      const double along_ground = std::min(at_contact(Vec3::UnitX()), at_contact(Vec3::UnitY()));
      if (std::isfinite(wheel->tangential_stiffness_npm)) {
        check_spring(link.name, "wheel's tangential spring", wheel->tangential_stiffness_npm,
                     along_ground);
      }
      check_damper(link.name, "wheel's tangential damper", wheel->tangential_damping_nspm,
                   along_ground);
    }
    if (link.steering) {
      check_spring(link.name, "steering servo", link.steering->stiffness_n_m_prad, joint);
      check_damper(link.name, "steering servo", link.steering->damping_n_m_sprad, joint);
    }
    if (link.limb) {
      check_spring(link.name, "limb's servo", link.limb->motor.stiffness_n_m_prad, joint);
      check_damper(link.name, "limb's servo", link.limb->motor.damping_n_m_sprad, joint);
    }
    if (link.drive) {
      check_spring(link.name, "brake", link.drive->brake_stiffness_n_m_prad, joint);
      check_damper(link.name, "brake", link.drive->brake_damping_n_m_sprad, joint);
      check_damper(link.name, "drive servo", link.drive->servo_gain_n_m_sprad, joint);
    }
    if (link.spring) {
      check_spring(link.name, "suspension spring", link.spring->stiffness, joint);
      check_damper(link.name, "suspension damper", link.spring->damping, joint);
      check_spring(link.name, "suspension's stops",
                   link.spring->stiffness + link.spring->stop_stiffness, joint);
      check_damper(link.name, "suspension's stops",
                   link.spring->damping + link.spring->stop_damping, joint);
    }
  }
  if (!vehicle.limbs.empty()) {
    const double mode = inertia.stiffest_mode_radps() * step_s;
    if (mode > 1 && faults.empty()) {
      faults.push_back(fmt::format(
          "step_s = {}: too long for its limbs, whose joints and wheels together have a mode with "
          "omega x step of {:.2f}, at most 1 is stable; a step of {:.4f} s or less, or softer "
          "servos",
          step_s, mode, step_s / mode));
    }
  }
  for (const JointCoupling& coupling : vehicle.couplings) {
    const std::string& name = vehicle.links[static_cast<std::size_t>(coupling.first)].name;
    const double moved = inertia.of_coupling(coupling);
    check_spring(name, "differential", coupling.stiffness_n_m_prad, moved);
    check_damper(name, "differential", coupling.damping_n_m_sprad, moved);
  }
  return faults;
}

bool is_balanced(const VehicleConfig& vehicle, const Vec3& up_B) {
  std::vector<Vec2> feet_B_m;
  for (const StandingWheel& wheel : standing_wheels(vehicle)) {
    feet_B_m.push_back(wheel.hub_B_m.head<2>());
  }
  const Vec3 center_B_m = center_of_mass_at_rest_B_m(vehicle);
  return is_within_hull((center_B_m - center_B_m.z() / up_B.z() * up_B).head<2>(), feet_B_m);
}

std::vector<std::string> balance_faults(const VehicleConfig& vehicle) {
  const Vec3 center_B_m = center_of_mass_at_rest_B_m(vehicle);
  if (is_balanced(vehicle, Vec3::UnitZ())) return {};
  return {
      fmt::format("the centre of mass of the whole, {:.3f} m forward and {:.3f} m to the left, "
                  "is not over its wheels: it would tip over at rest",
                  center_B_m.x(), center_B_m.y())};
}

std::vector<std::string> buried_joint_faults(const VehicleConfig& vehicle) {
  std::vector<std::string> faults;
  for (const LimbConfig& limb : vehicle.limbs) {
    for (const int joint : limb.joints) {
      const double height_m = joint_at_rest_B_m(vehicle, joint).z();
      if (height_m > 0) continue;
      faults.push_back(fmt::format("{} is {:.3f} m below the ground at rest",
                                   vehicle.links[static_cast<std::size_t>(joint)].name, -height_m));
    }
  }
  return faults;
}

std::vector<std::string> rest_faults(const VehicleConfig& vehicle, double height_tolerance_m) {
  std::vector<std::string> faults;
  const std::vector<StandingWheel> wheels = standing_wheels(vehicle);
  if (wheels.size() < 3) {
    return {fmt::format("{} wheels: at least 3 are needed to stand on", wheels.size())};
  }
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    check_height(wheels[i], height_tolerance_m, faults);
    for (std::size_t j = 0; j < i; ++j) check_overlap(wheels[j], wheels[i], faults);
  }
  if (vehicle.chassis_clearance_m <= 0) {
    faults.push_back("the chassis' underside is not above the ground at rest");
  }
  if (vehicle.p_BC_m.z() <= 0) {
    faults.push_back("the chassis' centre of mass is not above the ground at rest");
  }
  return faults;
}

std::vector<std::string> ability_faults(const VehicleConfig& vehicle) {
  std::vector<std::string> faults;
  const WheelLayout layout = wheel_layout(vehicle);
  const auto turns_about = [&](const Vec2& center_B_m, const std::string& what) {
    for (const WheelLayout::Steering& steering : layout.steerings) {
      const double needed_rad = rolling_angle_rad(steering, center_B_m);
      if (needed_rad <= steering.angle_max_rad) continue;
      faults.push_back(
          fmt::format("{}: {} would have to steer by {:.0f} deg, its angle_max_rad is {:.0f} deg",
                      what, vehicle.links[static_cast<std::size_t>(steering.link)].name,
                      degrees(needed_rad), degrees(steering.angle_max_rad)));
      return;
    }
  };
  if (vehicle.can_turn_on_spot) turns_about({layout.turning_x_B_m, 0}, "can_turn_on_spot");
  if (!layout.steerings.empty()) {
    turns_about({layout.turning_x_B_m, vehicle.turning_radius_min_m},
                fmt::format("turning_radius_min_m = {}", vehicle.turning_radius_min_m));
  }
  if (vehicle.can_crab) {
    const bool is_all_steered =
        std::ranges::all_of(layout.wheels, [](const auto& wheel) { return wheel.steering >= 0; });
    const bool reaches = std::ranges::all_of(layout.steerings, [](const auto& steering) {
      return steering.angle_max_rad >= std::numbers::pi / 2;
    });
    if (!is_all_steered) {
      faults.push_back("can_crab: not all of its wheels are steered");
    } else if (!reaches) {
      faults.push_back("can_crab: its steering does not reach 90 deg either way");
    }
  }
  for (const auto& wheel : layout.wheels) {
    const LinkConfig& link = vehicle.links[static_cast<std::size_t>(wheel.link)];
    const double needed_radps = vehicle.speed_max_mps / wheel.radius_m;
    if (link.wheel_mode != WheelMode::driven || link.drive->no_load_speed_radps > needed_radps)
      continue;
    faults.push_back(
        fmt::format("no_load_speed_radps = {}: speed_max_mps needs more than {:.3f} rad/s",
                    link.drive->no_load_speed_radps, needed_radps));
    break;
  }
  return faults;
}

std::vector<std::string> grouser_faults(const Wheel& wheel) {
  std::vector<std::string> faults;
  if (wheel.grouser_height_m > 0 && wheel.grouser_count == 0) {
    faults.push_back("the wheel has a grouser_height_m but no grouser_count");
  }
  if (wheel.grouser_count > 0 && wheel.grouser_height_m == 0) {
    faults.push_back("the wheel has a grouser_count but no grouser_height_m");
  }
  if (wheel.grouser_height_m >= wheel.radius_m) {
    faults.push_back(
        fmt::format("grouser_height_m = {}: must be less than the wheel's radius, {} m",
                    wheel.grouser_height_m, wheel.radius_m));
  }
  return faults;
}

}  // namespace lsos
