#include "vehicle/suspension/legged.h"

#include <fmt/format.h>

#include <set>

#include "vehicle/suspension/link_parts.h"

namespace lsos {

namespace {

constexpr double ball_radius_m = 0.05;  // of what a segment carries besides its rod

// A rod along `rod_m` and a ball. Products of inertia are neglected.
Inertia segment(double mass_kg, const Vec3& rod_m) {
  const Vec3 squares = rod_m.cwiseProduct(rod_m);
  const Vec3 rod(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
  return {mass_kg, mass_kg * (rod / 12 + Vec3::Constant(0.4 * ball_radius_m * ball_radius_m))};
}

}  // namespace

void add_legged(VehicleConfig& vehicle, const Legged& suspension) {
  vehicle.posture = suspension.posture;
  const double hub_m = suspension.wheel.radius_m;
  Inertia wheel = disc(suspension.wheel_mass_kg, hub_m, suspension.wheel.width_m);
  wheel.moments_kgm2 = suspension.wheel_moments_kgm2.value_or(wheel.moments_kgm2);
  for (const Limb& limb : suspension.limbs) {
    LimbConfig chain;
    chain.name = limb.name;
    const Vec3 hub_B_m(limb.p_B_wheel_m.x(), limb.p_B_wheel_m.y(), hub_m);
    int carrier = -1;
    Vec3 carrier_B_m = Vec3::Zero();
    for (std::size_t j = 0; j < limb.joints.size(); ++j) {
      const LimbJoint& joint = limb.joints[j];
      const Vec3 next_B_m = j + 1 < limb.joints.size() ? limb.joints[j + 1].p_B_m : hub_B_m;
      const Vec3 center_B_m = joint.p_B_center_m.value_or((joint.p_B_m + next_B_m) / 2);
      LinkConfig link;
      link.name = limb.name + "_" + joint.name;
      link.parent = carrier;
      link.axis = joint.axis_B;
      link.p_PJ_m = joint.p_B_m - carrier_B_m;
      link.p_JC_m = center_B_m - joint.p_B_m;
      link.inertia = segment(joint.mass_kg, next_B_m - joint.p_B_m);
      link.inertia.moments_kgm2 = joint.moments_kgm2.value_or(link.inertia.moments_kgm2);
      link.limb = joint.actuator;
      vehicle.links.push_back(link);
      carrier = static_cast<int>(vehicle.links.size()) - 1;
      carrier_B_m = joint.p_B_m;
      chain.joints.push_back(carrier);
    }
    if (limb.is_steered) {
      carrier =
          add_knuckle(vehicle, limb.name + "_steering", carrier, hub_B_m - carrier_B_m,
                      box(suspension.knuckle_mass_kg, Vec3::Constant(hub_m)), suspension.steering);
      carrier_B_m = hub_B_m;
    }
    chain.wheel = add_wheel(vehicle, limb.name + "_wheel", carrier, hub_B_m - carrier_B_m, wheel,
                            suspension.wheel, suspension.drive);
    vehicle.limbs.push_back(chain);
  }
}

std::vector<std::string> legged_faults(const Legged& suspension) {
  std::vector<std::string> faults;
  std::set<std::string> limbs;
  for (const Limb& limb : suspension.limbs) {
    if (!limbs.insert(limb.name).second) {
      faults.push_back(fmt::format("two limbs are named '{}'", limb.name));
    }
    if (limb.joints.empty()) {
      faults.push_back(fmt::format("limb '{}' has no joints: it needs at least one", limb.name));
    }
    std::set<std::string> joints{"steering", "wheel"};
    for (const LimbJoint& joint : limb.joints) {
      if (joints.insert(joint.name).second) continue;
      const bool is_ours = joint.name == "steering" || joint.name == "wheel";
      faults.push_back(
          is_ours ? fmt::format("limb '{}': no joint may be named '{}', which is the "
                                "name of another part of it",
                                limb.name, joint.name)
                  : fmt::format("limb '{}' has two joints named '{}'", limb.name, joint.name));
    }
  }
  return faults;
}

}  // namespace lsos
