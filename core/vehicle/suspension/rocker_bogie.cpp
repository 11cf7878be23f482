#include "vehicle/suspension/rocker_bogie.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "vehicle/suspension/link_parts.h"

namespace lsos {

namespace {

// Least edges of the box that an arm's default moments are computed from; see
// SwingArm::moments_kgm2.
constexpr double edge_share_min = 0.2, edge_min_m = 0.05;

// The point on its side: the right side is the left one mirrored at y = 0.
Vec3 on_side(const Vec3& p_left_m, bool is_left) {
  return {p_left_m.x(), is_left ? p_left_m.y() : -p_left_m.y(), p_left_m.z()};
}

// Points that an arm joins, on the left.
std::vector<Vec3> joined_B_m(const RockerBogie& s, Arm arm) {
  const bool is_rocker = arm == Arm::rocker;
  std::vector<Vec3> points{is_rocker ? s.rocker.p_B_pivot_m : s.bogie->p_B_pivot_m};
  if (is_rocker && s.bogie) points.push_back(s.bogie->p_B_pivot_m);
  for (const WheelStation& station : s.stations) {
    if (station.arm != arm) continue;
    points.emplace_back(station.p_B_m.x(), station.p_B_m.y(), s.wheel.radius_m);
  }
  return points;
}

int add_arm(VehicleConfig& vehicle, const SwingArm& arm, const std::string& name, int parent,
            const Vec3& p_B_parent_m, std::vector<Vec3> joined_left_m, bool is_left) {
  Vec3 middle_m = Vec3::Zero();
  Vec3 low_m = joined_left_m.front(), high_m = low_m;
  for (const Vec3& p_m : joined_left_m) {
    middle_m += p_m / static_cast<double>(joined_left_m.size());
    low_m = low_m.cwiseMin(p_m);
    high_m = high_m.cwiseMax(p_m);
  }
  const Vec3 extent_m = high_m - low_m;
  LinkConfig link;
  link.name = name;
  link.parent = parent;
  link.axis = Vec3::UnitY();
  link.p_PJ_m = on_side(arm.p_B_pivot_m, is_left) - p_B_parent_m;
  link.p_JC_m = on_side(arm.p_B_center_m.value_or(middle_m) - arm.p_B_pivot_m, is_left);
  link.inertia = box(arm.mass_kg,
                     extent_m.cwiseMax(std::max(edge_share_min * extent_m.maxCoeff(), edge_min_m)));
  link.inertia.moments_kgm2 = arm.moments_kgm2.value_or(link.inertia.moments_kgm2);
  link.spring = SpringDamper{.damping = arm.damping_n_m_sprad,
                             .lower_stop = -arm.angle_max_rad,
                             .upper_stop = arm.angle_max_rad,
                             .stop_stiffness = arm.stop_stiffness_n_m_prad,
                             .stop_damping = arm.stop_damping_n_m_sprad};
  vehicle.links.push_back(link);
  return static_cast<int>(vehicle.links.size()) - 1;
}

// Adds the links of one side; returns the rocker's index.
int add_side(VehicleConfig& vehicle, const RockerBogie& s, bool is_left) {
  const std::string side = is_left ? "left" : "right";
  const Vec3 p_B_rocker_m = on_side(s.rocker.p_B_pivot_m, is_left);
  const int rocker = add_arm(vehicle, s.rocker, "rocker_" + side, -1, Vec3::Zero(),
                             joined_B_m(s, Arm::rocker), is_left);
  int bogie = -1;
  Vec3 p_B_bogie_m = Vec3::Zero();
  if (s.bogie) {
    p_B_bogie_m = on_side(s.bogie->p_B_pivot_m, is_left);
    bogie = add_arm(vehicle, *s.bogie, "bogie_" + side, rocker, p_B_rocker_m,
                    joined_B_m(s, Arm::bogie), is_left);
  }
  const double radius_m = s.wheel.radius_m;
  Inertia wheel = disc(s.wheel_mass_kg, radius_m, s.wheel.width_m);
  wheel.moments_kgm2 = s.wheel_moments_kgm2.value_or(wheel.moments_kgm2);
  for (const WheelStation& station : s.stations) {
    const bool is_on_bogie = station.arm == Arm::bogie;
    const std::string name = station.name + "_" + side;
    const Vec3 hub_B_m = on_side({station.p_B_m.x(), station.p_B_m.y(), radius_m}, is_left);
    int carrier = is_on_bogie ? bogie : rocker;
    Vec3 p_PJ_m = hub_B_m - (is_on_bogie ? p_B_bogie_m : p_B_rocker_m);
    if (station.is_steered) {
      carrier = add_knuckle(vehicle, name + "_steering", carrier, p_PJ_m,
                            box(s.knuckle_mass_kg, Vec3::Constant(radius_m)), s.steering);
      p_PJ_m = Vec3::Zero();
    }
    const int link = add_wheel(vehicle, name + "_wheel", carrier, p_PJ_m, wheel, s.wheel, s.drive);
    if (!station.is_driven) {
      vehicle.links[static_cast<std::size_t>(link)].wheel_mode = WheelMode::free;
    }
  }
  return rocker;
}

}  // namespace

void add_rocker_bogie(VehicleConfig& vehicle, const RockerBogie& suspension) {
  const Differential& differential = suspension.differential;
  add_point_mass(vehicle.chassis, vehicle.p_BC_m, differential.mass_kg, differential.p_B_m);
  const int left = add_side(vehicle, suspension, true);
  const int right = add_side(vehicle, suspension, false);
  vehicle.couplings.push_back(
      {left, right, differential.stiffness_n_m_prad, differential.damping_n_m_sprad});
}

std::vector<std::string> station_faults(const std::vector<WheelStation>& stations,
                                        double wheel_width_m) {
  std::vector<std::string> faults;
  if (stations.size() < 2) {
    faults.push_back(
        fmt::format("{} wheels: at least 3 are needed to stand on", 2 * stations.size()));
  }
  std::set<std::string> names;
  for (const WheelStation& station : stations) {
    if (!names.insert(station.name).second) {
      faults.push_back(fmt::format("two stations are named '{}'", station.name));
    }
    if (station.p_B_m.y() < 0) {
      faults.push_back(
          fmt::format("station '{}': position_m: y = {} is on the right; the left wheel's place is "
                      "wanted, the right one is its mirror image",
                      station.name, station.p_B_m.y()));
    } else if (2 * station.p_B_m.y() < wheel_width_m) {
      faults.push_back(fmt::format("station '{}': the track of {} m is narrower than a wheel, {} m",
                                   station.name, 2 * station.p_B_m.y(), wheel_width_m));
    }
  }
  return faults;
}

std::vector<std::string> rocker_bogie_faults(const RockerBogie& suspension) {
  std::vector<std::string> faults = station_faults(suspension.stations, suspension.wheel.width_m);
  int on_rocker = 0, on_bogie = 0;
  double front_m = -1e9, rear_m = 1e9;  // extent of the bogie's stations
  for (const WheelStation& station : suspension.stations) {
    if (station.arm == Arm::rocker) {
      ++on_rocker;
      continue;
    }
    ++on_bogie;
    front_m = std::max(front_m, station.p_B_m.x());
    rear_m = std::min(rear_m, station.p_B_m.x());
    if (!suspension.bogie) {
      faults.push_back(
          fmt::format("station '{}' is on the bogie, but there is no bogie", station.name));
    }
  }
  if (suspension.bogie) {
    const double pivot_m = suspension.bogie->p_B_pivot_m.x();
    if (on_bogie < 2) {
      faults.push_back(fmt::format(
          "the bogie carries {} stations: at least 2 are needed, or none and no bogie", on_bogie));
    } else if (pivot_m <= rear_m || pivot_m >= front_m) {
      faults.push_back(
          fmt::format("the bogie's pivot at x = {} m is not between its stations, "
                      "{} to {} m: it would tip over",
                      pivot_m, rear_m, front_m));
    }
    if (on_rocker == 0) {
      faults.push_back("the rocker carries the bogie alone: it needs a station of its own");
    }
    if (suspension.bogie->p_B_pivot_m.z() <= 0) {
      faults.push_back("the bogie's pivot is not above the ground at rest");
    }
  }
  if (suspension.rocker.p_B_pivot_m.z() <= 0) {
    faults.push_back("the rocker's pivot is not above the ground at rest");
  }
  return faults;
}

}  // namespace lsos
