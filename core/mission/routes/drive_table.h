// What planning knows of a rover (route/cost/drive_cost.h), worked out with the wheels of the
// simulation.
#pragma once

#include <vector>

#include "route/cost/drive_cost.h"
#include "route/map/ground_limits.h"
#include "terrain/spec/soil.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Steady driving with the load shared evenly by the wheels, each as on a single-wheel test bed.
// Slips at which all wheels pull as much as the slope wants; electrical power by torque, speed,
// efficiency and the rover's drive calibration. `speed_mps`: that the rover is asked to drive.
DriveCost drive_cost(const VehicleConfig& vehicle, const std::vector<Soil>& soils,
                     double gravity_mps2, double speed_mps, const GroundLimits& limits = {});

// Of the wheel farthest from the reference point, 0.3 m at least.
double wheel_reach_m(const VehicleConfig& vehicle);
// How fast it turns on the spot.
double turn_rate_radps(const VehicleConfig& vehicle);

}  // namespace lsos
