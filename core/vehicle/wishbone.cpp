#include "vehicle/wishbone.h"

#include <fmt/format.h>

#include "vehicle/vehicle_checks.h"

namespace lsos {

namespace {

// A solid box of this mass and edge lengths.
Inertia box(double mass_kg, const Vec3& size_m) {
  const Vec3 square = size_m.array().square();
  return {mass_kg,
          mass_kg / 12 *
              Vec3(square.y() + square.z(), square.x() + square.z(), square.x() + square.y())};
}

// A disc of even mass with its axle along y: the mean of a hoop and a solid cylinder would suit a
// wheel with a light rim as well; the solid cylinder is the usual first figure.
Inertia disc(double mass_kg, double radius_m, double width_m) {
  const double across = mass_kg * (3 * radius_m * radius_m + width_m * width_m) / 12;
  return {mass_kg, {across, mass_kg * radius_m * radius_m / 2, across}};
}

}  // namespace

void add_wishbone(VehicleConfig& vehicle, const Wishbone& wishbone, double gravity_mps2) {
  const double sprung_n =
      vehicle.chassis.mass_kg * gravity_mps2 / static_cast<double>(wishbone.modules.size());
  for (const WishboneModule& module : wishbone.modules) {
    const double hub_m = wishbone.wheel.radius_m;
    LinkConfig arm;
    arm.name = module.name + "_arm";
    arm.joint = JointType::prismatic;
    arm.axis = Vec3::UnitZ();  // upward travel of the wheel is positive
    arm.p_PJ_m = {module.p_B_m.x(), module.p_B_m.y(), hub_m};
    arm.inertia = box(wishbone.arm_mass_kg, Vec3::Constant(hub_m));
    arm.spring = SpringDamper{.stiffness = wishbone.stiffness_npm,
                              .damping = wishbone.damping_nspm,
                              .preload = -sprung_n,
                              .lower_stop = -wishbone.travel_down_m,
                              .upper_stop = wishbone.travel_up_m,
                              .stop_stiffness = 5 * wishbone.stiffness_npm,
                              .stop_damping = wishbone.damping_nspm};
    vehicle.links.push_back(arm);

    LinkConfig knuckle;
    knuckle.name = module.name + "_steering";
    knuckle.parent = static_cast<int>(vehicle.links.size()) - 1;
    knuckle.axis = Vec3::UnitZ();
    knuckle.inertia = box(wishbone.knuckle_mass_kg, Vec3::Constant(hub_m));
    knuckle.steering = wishbone.steering;
    vehicle.links.push_back(knuckle);

    const int steered = static_cast<int>(vehicle.links.size()) - 1;
    for (std::size_t i = 0; i < wishbone.wheel_offsets_m.size(); ++i) {
      LinkConfig wheel;
      wheel.name = fmt::format("{}_wheel_{}", module.name, i + 1);
      wheel.parent = steered;
      wheel.axis = Vec3::UnitY();  // positive spin drives forward
      wheel.p_PJ_m = {0, wishbone.wheel_offsets_m[i], 0};
      wheel.inertia = disc(wishbone.wheel_mass_kg, hub_m, wishbone.wheel.width_m);
      wheel.wheel = wishbone.wheel;
      wheel.drive = wishbone.drive;
      vehicle.links.push_back(wheel);
    }
  }
  vehicle.assumptions.push_back(fmt::format(
      "{}: springs are preset for the ride height at {:.3f} m/s2", vehicle.type, gravity_mps2));
}

std::vector<std::string> wishbone_faults(const VehicleConfig& vehicle, const Wishbone& wishbone) {
  std::vector<std::string> faults;
  if (wishbone.modules.size() < 3) {
    faults.push_back(
        fmt::format("{} modules: at least 3 are needed to stand on", wishbone.modules.size()));
  }
  if (wishbone.wheel_offsets_m.empty()) faults.push_back("wheel_offsets_m is empty");
  if (vehicle.chassis_clearance_m <= 0) {
    faults.push_back("the chassis' underside is not above the ground at rest");
  }
  VehicleConfig whole = vehicle;
  add_wishbone(whole, wishbone, 1);
  for (std::string& fault : stability_faults(whole)) {
    if (faults.empty() || faults.back() != fault) faults.push_back(std::move(fault));
  }
  return faults;
}

}  // namespace lsos
