// Parts from which suspension templates build vehicles: bodies of simple shape, steering knuckles,
// wheels.
#pragma once

#include <optional>
#include <string>

#include "vehicle/vehicle_config.h"

namespace lsos {

// A solid box of uniform density.
Inertia box(double mass_kg, const Vec3& size_m);

// A wheel with its axle along y, as a solid cylinder. A hoop would have twice the moment about the
// axle, but wheels with motors in their hubs are nearer to the cylinder.
Inertia disc(double mass_kg, double radius_m, double width_m);

// Adds a point mass (negative: removes it) to `body` and moves `center_m`, the body's centre of
// mass. Products of inertia are neglected: principal axes stay along those of the frame.
void add_point_mass(Inertia& body, Vec3& center_m, double mass_kg, const Vec3& p_m);

// Both add a link to `vehicle` and return its index. `p_PJ_m` is that of LinkConfig.
int add_knuckle(VehicleConfig& vehicle, const std::string& name, int parent, const Vec3& p_PJ_m,
                const Inertia& inertia, const SteeringMotor& motor);
int add_wheel(VehicleConfig& vehicle, const std::string& name, int parent, const Vec3& p_PJ_m,
              const Inertia& inertia, const Wheel& wheel, const DriveMotor& drive);

// Position of a link's joint in frame B with all joints at 0.
Vec3 joint_at_rest_B_m(const VehicleConfig& vehicle, int link);

// Centre of mass of the whole vehicle with all joints at 0, in frame B.
Vec3 center_of_mass_at_rest_B_m(const VehicleConfig& vehicle);

}  // namespace lsos
