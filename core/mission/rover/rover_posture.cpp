#include "mission/rover/rover_posture.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "mission/port/equipment_fault.h"
#include "vehicle/limb_stance.h"
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

}  // namespace

double set_posture(Vehicle& vehicle, const PostureRequest& request) {
  const VehicleConfig& config = vehicle.config();
  if (vehicle.posture() == nullptr) {
    throw EquipmentFault(
        fmt::format("a {} has no limbs: it cannot change its stance", config.type));
  }
  const PostureControl& posture = *vehicle.posture();
  const std::vector<Vec3>& from_B_m = posture.hubs_B_m();
  std::vector<Vec3> to_B_m = from_B_m;
  bool is_level = true;
  if (request.stance) {
    const LimbStance& stance = stance_named(config, *request.stance);
    to_B_m = stance.hubs_B_m;
    is_level = stance.is_level;
  }
  if (request.height_m) to_B_m = at_height(config, to_B_m, *request.height_m);
  is_level = request.is_level.value_or(is_level);

  const PostureMove move =
      posture_move(config, from_B_m, to_B_m, vehicle.limb_angles_rad(), vehicle.limbs_locked());
  if (!move.hindrance.empty()) throw EquipmentFault(move.hindrance);
  if (request.duration_s && *request.duration_s < move.least_s) {
    throw EquipmentFault(fmt::format("{} needs {:.1f} s at its greatest rate, Duration is {:.6g} s",
                                     move.slowest_joint, move.least_s, *request.duration_s));
  }
  VehicleConfig standing = config;
  stand(standing, to_B_m);
  const Vec3 up_B = is_level ? Vec3(Vec3::UnitZ()) : vehicle.up_B();
  if (!is_balanced(as_it_stands(standing), up_B)) {
    throw EquipmentFault("its centre of mass would not be over its wheels");
  }
  const double takes_s = request.duration_s.value_or(move.least_s);
  vehicle.set_posture(to_B_m, is_level, takes_s);
  return takes_s;
}

double posture_clearance_m(const Vehicle& vehicle) {
  const PostureControl* posture = vehicle.posture();
  return posture == nullptr ? not_modelled : height_m(vehicle.config(), posture->hubs_B_m());
}

}  // namespace lsos
