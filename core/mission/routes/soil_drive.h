// Steady driving of a rover's wheels on one soil, by the wheel code of the simulation: the tables
// of planning.
#pragma once

#include <optional>
#include <vector>

#include "route/cost/drive_cost.h"
#include "vehicle/single_wheel.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

struct WheelDrive {
  Wheel wheel;
  std::optional<DriveMotor> motor;  // absent: it turns freely or, locked, not at all
  bool is_locked = false;

  bool operator==(const WheelDrive&) const = default;
};

std::vector<WheelDrive> wheels_of(const VehicleConfig& vehicle);

// State at which one driven wheel pulls `pull_n` with the least slip, from -0.5 to `slip_max`;
// absent when it cannot.
std::optional<SingleWheelPoint> state_at_pull(const WheelSoil& wheel, double load_n, double pull_n,
                                              double slip_max);

// Table of driving on the soil at the requested speed, up to the slope on which a wheel slips more
// than `slip_max` or its motor stalls, -40 to 40 degrees.
SoilDrive soil_drive(const VehicleConfig& vehicle, const std::vector<WheelDrive>& wheels,
                     const Soil& soil, double gravity_mps2, double speed_mps, double slip_max);

// Makes driving cost no less than `least`: what is worse of the two in each value.
void raise_to(SlopeDrive& drive, const SlopeDrive& least);

// A rock lies under one or two wheels while the others stand in the soil around it, so driving on
// rock costs no less than on the soil.
void raise_to_soil_cost(SoilDrive& rock, const SoilDrive& soil);

}  // namespace lsos
