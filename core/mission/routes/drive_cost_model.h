// The drive cost model of a rover that route planning uses (route/cost/drive_cost.h), computed with
// the wheel model of the simulation.
#pragma once

#include <vector>

#include "route/cost/drive_cost.h"
#include "route/map/ground_limits.h"
#include "terrain/spec/soil.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Steady driving with the load shared evenly by the wheels, each as on a single-wheel test bed. The
// slip is the one at which the driven wheels pull as much as the slope requires; electrical power
// follows from torque, speed, efficiency and the rover's drive calibration. `speed_mps`: requested
// speed.
DriveCost drive_cost(const VehicleConfig& vehicle, const std::vector<Soil>& soils,
                     double gravity_mps2, double speed_mps, const GroundLimits& limits = {});

// Distance of the farthest wheel from the reference point, at least 0.3 m.
double wheel_reach_m(const VehicleConfig& vehicle);
// Yaw rate of a turn on the spot.
double turn_rate_radps(const VehicleConfig& vehicle);

}  // namespace lsos
