// Parts that suspension templates build vehicles from: bodies of simple shape, steering knuckles,
// wheels.
#pragma once

#include <optional>
#include <string>

#include "vehicle/vehicle_config.h"

namespace lsos {

// A solid box with its mass spread evenly.
Inertia box(double mass_kg, const Vec3& size_m);

// A wheel with its axle along y: a solid cylinder. A hoop would have twice the moment about the
// axle; wheels with motors in their hubs are nearer to the cylinder.
Inertia disc(double mass_kg, double radius_m, double width_m);

// `body` with a point mass added (a negative one is taken away); moves `center_m`, the body's
// centre of mass. Products of inertia are left out, as principal axes stay along the frame's.
void add_point_mass(Inertia& body, Vec3& center_m, double mass_kg, const Vec3& p_m);

// Both add a link to `vehicle` and answer its index. `p_PJ_m` as in LinkConfig.
int add_knuckle(VehicleConfig& vehicle, const std::string& name, int parent, const Vec3& p_PJ_m,
                const Inertia& inertia, const SteeringMotor& motor);
int add_wheel(VehicleConfig& vehicle, const std::string& name, int parent, const Vec3& p_PJ_m,
              const Inertia& inertia, const Wheel& wheel, const DriveMotor& drive);

// Where a link's joint is in frame B with all joints at 0.
Vec3 joint_at_rest_B_m(const VehicleConfig& vehicle, int link);

// Of the whole vehicle with all joints at 0, in frame B.
Vec3 center_of_mass_at_rest_B_m(const VehicleConfig& vehicle);

}  // namespace lsos
