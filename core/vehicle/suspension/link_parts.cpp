#include "vehicle/suspension/link_parts.h"

namespace lsos {

namespace {

// Moments about the axes through the origin of a mass of 1 kg at p.
Vec3 arms_squared(const Vec3& p) {
  const Vec3 square = p.cwiseProduct(p);
  return {square.y() + square.z(), square.x() + square.z(), square.x() + square.y()};
}

}  // namespace

Inertia box(double mass_kg, const Vec3& size_m) {
  return {mass_kg, mass_kg / 12 * arms_squared(size_m)};
}

Inertia disc(double mass_kg, double radius_m, double width_m) {
  const double across = mass_kg * (3 * radius_m * radius_m + width_m * width_m) / 12;
  return {mass_kg, {across, mass_kg * radius_m * radius_m / 2, across}};
}

void add_point_mass(Inertia& body, Vec3& center_m, double mass_kg, const Vec3& p_m) {
  const double whole_kg = body.mass_kg + mass_kg;
  const Vec3 center_of_both_m = (body.mass_kg * center_m + mass_kg * p_m) / whole_kg;
  body.moments_kgm2 += body.mass_kg * arms_squared(center_m - center_of_both_m) +
                       mass_kg * arms_squared(p_m - center_of_both_m);
  body.mass_kg = whole_kg;
  center_m = center_of_both_m;
}

int add_knuckle(VehicleConfig& vehicle, const std::string& name, int parent, const Vec3& p_PJ_m,
                const Inertia& inertia, const SteeringMotor& motor) {
  LinkConfig link;
  link.name = name;
  link.parent = parent;
  link.axis = Vec3::UnitZ();
  link.p_PJ_m = p_PJ_m;
  link.inertia = inertia;
  link.steering = motor;
  vehicle.links.push_back(link);
  return static_cast<int>(vehicle.links.size()) - 1;
}

int add_wheel(VehicleConfig& vehicle, const std::string& name, int parent, const Vec3& p_PJ_m,
              const Inertia& inertia, const Wheel& wheel, const DriveMotor& drive) {
  LinkConfig link;
  link.name = name;
  link.parent = parent;
  link.axis = Vec3::UnitY();  // positive spin drives forward
  link.p_PJ_m = p_PJ_m;
  link.inertia = inertia;
  link.wheel = wheel;
  link.drive = drive;
  vehicle.links.push_back(link);
  return static_cast<int>(vehicle.links.size()) - 1;
}

Vec3 joint_at_rest_B_m(const VehicleConfig& vehicle, int link) {
  Vec3 p_B_m = Vec3::Zero();
  for (; link >= 0; link = vehicle.links[static_cast<std::size_t>(link)].parent) {
    p_B_m += vehicle.links[static_cast<std::size_t>(link)].p_PJ_m;
  }
  return p_B_m;
}

Vec3 center_of_mass_at_rest_B_m(const VehicleConfig& vehicle) {
  Vec3 sum = vehicle.chassis.mass_kg * vehicle.p_BC_m;
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    const LinkConfig& link = vehicle.links[i];
    sum += link.inertia.mass_kg * (joint_at_rest_B_m(vehicle, static_cast<int>(i)) + link.p_JC_m);
  }
  return sum / vehicle.mass_kg();
}

}  // namespace lsos
