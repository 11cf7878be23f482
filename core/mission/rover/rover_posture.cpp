#include "mission/rover/rover_posture.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "mission/port/equipment_fault.h"
#include "vehicle/limb_stance.h"
#include "vehicle/plane_fit.h"
#include "vehicle/posture_move.h"
#include "vehicle/suspension/vehicle_checks.h"

namespace lsos {

namespace {

const LimbStance& stance_named(const VehicleConfig& vehicle, const std::string& name) {
  const auto found = std::ranges::find(vehicle.stances, name, &LimbStance::name);
  if (found != vehicle.stances.end()) return *found;
  std::vector<std::string> names;
  for (const LimbStance& stance : vehicle.stances) names.push_back(stance.name);
  throw std::runtime_error(fmt::format("{} has no stance '{}'{}; it has {}", vehicle.type, name,
                                       did_you_mean(name, names), fmt::join(names, ", ")));
}

std::vector<Vec3> commanded_hubs_B_m(const Vehicle& vehicle) {
  const std::vector<std::vector<double>> angles_rad = vehicle.limb_angles_rad();
  std::vector<Vec3> hubs_B_m;
  for (std::size_t i = 0; i < angles_rad.size(); ++i) {
    hubs_B_m.push_back(vehicle.posture()->chains()[i].pose(angles_rad[i]).hub_B_m);
  }
  return hubs_B_m;
}

// The hubs of a stance on the ground that the rover stands on: limbs stay as far out as they are,
// but for what levels the chassis, or lays it parallel to the plane of its wheels.
std::vector<Vec3> on_this_ground_B_m(const Vehicle& vehicle, const std::vector<Vec3>& stance_B_m,
                                     bool is_level) {
  const std::vector<Vec3>& nominal_B_m = vehicle.posture()->hubs_B_m();
  const std::vector<Vec3> hubs_B_m = commanded_hubs_B_m(vehicle);
  std::vector<Vec3> extensions;
  for (std::size_t i = 0; i < hubs_B_m.size(); ++i) {
    const double extension_m = hubs_B_m[i].z() - nominal_B_m[i].z();
    extensions.emplace_back(nominal_B_m[i].x(), nominal_B_m[i].y(), extension_m);
  }
  const PlaneFit plane = fit_plane(extensions, Vec3::UnitZ());
  const Vec3 along_B = is_level ? vehicle.up_B() : plane.normal;
  const Vec2 gradient = along_B.head<2>() / along_B.z();
  std::vector<Vec3> there_B_m = stance_B_m;
  for (std::size_t i = 0; i < there_B_m.size(); ++i) {
    const Vec2 from_middle_m = (nominal_B_m[i] - plane.point).head<2>();
    // Without the mean: the chassis has its height over the middle of its wheels.
    there_B_m[i].z() += extensions[i].z() - plane.point.z() + gradient.dot(from_middle_m);
  }
  return there_B_m;
}

// The vertical in the axes of a chassis that lies parallel to the plane of its wheels.
Vec3 up_over_wheels(const Vehicle& vehicle) {
  const Vec3 normal_B = fit_plane(vehicle.hubs_B_m(), Vec3::UnitZ()).normal;
  return Quat::FromTwoVectors(normal_B, Vec3::UnitZ()) * vehicle.up_B();
}

}  // namespace

PostureTime set_posture(Vehicle& vehicle, const PostureRequest& request) {
  const VehicleConfig& config = vehicle.config();
  if (vehicle.posture() == nullptr) {
    throw EquipmentFault(
        fmt::format("a {} has no limbs: it cannot change its stance", config.type));
  }
  if (request.is_level && !config.posture) {
    throw EquipmentFault(
        fmt::format("Level: {} has no posture control: it lies as the ground does", config.type));
  }
  const PostureControl& posture = *vehicle.posture();
  // Without a stance or a height the limbs end where a move under way would have ended.
  std::vector<Vec3> to_B_m = posture.target_hubs_B_m();
  bool is_level = true;
  if (request.stance) {
    const LimbStance& stance = stance_named(config, *request.stance);
    to_B_m = stance.hubs_B_m;
    is_level = stance.is_level;
  }
  if (request.height_m) to_B_m = at_height(config, to_B_m, *request.height_m);
  is_level = config.posture && request.is_level.value_or(is_level);

  const std::vector<Vec3>& nominal_B_m = posture.hubs_B_m();
  std::vector<Vec3> from_B_m = commanded_hubs_B_m(vehicle);
  for (std::size_t i = 0; i < from_B_m.size(); ++i) {
    from_B_m[i].head<2>() = nominal_B_m[i].head<2>();
  }
  const PostureMove move = posture_move(
      config, from_B_m, config.posture ? on_this_ground_B_m(vehicle, to_B_m, is_level) : to_B_m,
      vehicle.limb_angles_rad(), vehicle.limbs_locked());
  if (!move.hindrance.empty()) throw EquipmentFault(move.hindrance);
  if (request.duration_s && *request.duration_s < move.least_s) {
    throw EquipmentFault(fmt::format("{} needs {:.1f} s at its greatest rate, Duration is {:.6g} s",
                                     move.slowest_joint, move.least_s, *request.duration_s));
  }
  VehicleConfig standing = config;
  stand(standing, to_B_m);
  if (!is_balanced(as_it_stands(standing),
                   is_level ? Vec3(Vec3::UnitZ()) : up_over_wheels(vehicle))) {
    throw EquipmentFault("its centre of mass would not be over its wheels");
  }
  const double takes_s = request.duration_s.value_or(move.least_s);
  vehicle.set_posture(to_B_m, is_level, takes_s);
  return {takes_s, move.least_s};
}

PostureWork expected_work(const Vehicle& vehicle, const PostureTime& time, double rise_m,
                          double gravity_mps2) {
  const VehicleConfig& config = vehicle.config();
  PostureWork work;
  const double rate_share = time.takes_s > 0 ? time.least_s / time.takes_s : 1;
  work.takes_s = time.takes_s + vehicle.posture()->settling_s(rate_share);
  double raised_kg = config.chassis.mass_kg, efficiency = 1;
  for (const LinkConfig& link : config.links) {
    if (!link.limb) continue;
    raised_kg += link.inertia.mass_kg / 2;
    efficiency = std::min(efficiency, link.limb->motor.efficiency);
    work.energy_j += link.limb->motor.idle_w * work.takes_s;
  }
  work.energy_j += raised_kg * gravity_mps2 * std::max(0.0, rise_m) / efficiency;
  return work;
}

double posture_clearance_m(const Vehicle& vehicle) {
  return vehicle.posture() == nullptr ? not_modelled
                                      : height_m(vehicle.config(), vehicle.hubs_B_m());
}

}  // namespace lsos
