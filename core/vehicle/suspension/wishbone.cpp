#include "vehicle/suspension/wishbone.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <set>

#include "vehicle/suspension/link_parts.h"

namespace lsos {

namespace {

// Shares of a load at `p_B_m` that keep the modules in balance, and are as nearly equal as that
// allows; they are linear in x and y. Without a solution the shares are equal.
std::vector<double> shares_in_balance(const std::vector<WishboneModule>& modules,
                                      const Vec2& p_B_m) {
  Mat3 sums = Mat3::Zero();
  for (const WishboneModule& module : modules) {
    const Vec3 place(1, module.p_B_m.x(), module.p_B_m.y());
    sums += place * place.transpose();
  }
  const Eigen::FullPivLU<Mat3> solver(sums);
  std::vector<double> shares;
  for (const WishboneModule& module : modules) {
    const Vec3 place(1, module.p_B_m.x(), module.p_B_m.y());
    shares.push_back(solver.isInvertible() ? place.dot(solver.solve(Vec3(1, p_B_m.x(), p_B_m.y())))
                                           : 1.0 / static_cast<double>(modules.size()));
  }
  return shares;
}

}  // namespace

void add_wishbone(VehicleConfig& vehicle, const Wishbone& wishbone, double gravity_mps2) {
  const double sprung_n = vehicle.chassis.mass_kg * gravity_mps2;
  const std::vector<double> shares = shares_in_balance(wishbone.modules, vehicle.p_BC_m.head<2>());
  const double hub_m = wishbone.wheel.radius_m;
  Inertia wheel = disc(wishbone.wheel_mass_kg, hub_m, wishbone.wheel.width_m);
  wheel.moments_kgm2 = wishbone.wheel_moments_kgm2.value_or(wheel.moments_kgm2);
  for (std::size_t m = 0; m < wishbone.modules.size(); ++m) {
    const WishboneModule& module = wishbone.modules[m];
    LinkConfig arm;
    arm.name = module.name + "_arm";
    arm.joint = JointType::prismatic;
    arm.axis = Vec3::UnitZ();  // upward travel of the wheel is positive
    arm.p_PJ_m = {module.p_B_m.x(), module.p_B_m.y(), hub_m};
    arm.inertia = box(wishbone.arm_mass_kg, Vec3::Constant(hub_m));
    arm.spring = SpringDamper{.stiffness = wishbone.stiffness_npm,
                              .damping = wishbone.damping_nspm,
                              .preload = -sprung_n * shares[m],
                              .lower_stop = -wishbone.travel_down_m,
                              .upper_stop = wishbone.travel_up_m,
                              .stop_stiffness = 5 * wishbone.stiffness_npm,
                              .stop_damping = wishbone.damping_nspm};
    vehicle.links.push_back(arm);
    int carrier = static_cast<int>(vehicle.links.size()) - 1;
    if (module.is_steered) {
      carrier =
          add_knuckle(vehicle, module.name + "_steering", carrier, Vec3::Zero(),
                      box(wishbone.knuckle_mass_kg, Vec3::Constant(hub_m)), wishbone.steering);
    }
    for (std::size_t i = 0; i < wishbone.wheel_offsets_m.size(); ++i) {
      add_wheel(vehicle, fmt::format("{}_wheel_{}", module.name, i + 1), carrier,
                {0, wishbone.wheel_offsets_m[i], 0}, wheel, wishbone.wheel, wishbone.drive);
    }
  }
  vehicle.assumptions.push_back(fmt::format(
      "{}: springs are preset for the ride height at {:.3f} m/s2", vehicle.type, gravity_mps2));
}

std::vector<std::string> wishbone_faults(const Wishbone& wishbone) {
  std::vector<std::string> faults;
  if (wishbone.modules.size() < 3) {
    faults.push_back(
        fmt::format("{} modules: at least 3 are needed to stand on", wishbone.modules.size()));
  }
  if (wishbone.wheel_offsets_m.empty()) faults.push_back("wheel_offsets_m is empty");
  std::set<std::string> names;
  for (const WishboneModule& module : wishbone.modules) {
    if (!names.insert(module.name).second) {
      faults.push_back(fmt::format("two modules are named '{}'", module.name));
    }
  }
  return faults;
}

}  // namespace lsos
