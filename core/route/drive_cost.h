// What driving costs a rover, and where it can stand: all that planning knows of it. Plain values;
// mission/drive_table.h makes them with the wheel code of the simulation.
#pragma once

#include <vector>

#include "base/vector.h"

namespace lsos {

// Steady driving on an even slope.
struct SlopeDrive {
  double slip = 0;        // 0..1
  double energy_jpm = 0;  // electrical, for each metre along the ground
  double speed_mps = 0;   // that the rover asks for and its motors can keep
};

// On one soil, straight up slopes from `first_rad` (negative: down) in even steps; the last is the
// steepest that it climbs.
struct SoilDrive {
  double first_rad = 0, step_rad = 0;
  std::vector<SlopeDrive> by_slope;

  double last_rad() const {
    return first_rad + step_rad * static_cast<double>(by_slope.size() - 1);
  }
  // Linear between. Above last_rad() nothing climbs: ask first. Below the first slope as on it.
  SlopeDrive at(double slope_rad) const;
};

// Limits of where it may stand, and what it may demand of itself.
struct DriveLimits {
  double slope_max_rad = 0.35;    // of the plane under its wheels, in any direction
  double slip_max = 0.6;          // steady, climbing
  double clearance_min_m = 0.05;  // between its underside and the ground
  double unevenness_max_m = 0.1;  // of the ground at a wheel from the plane under all
};

struct DriveCost {
  std::vector<SoilDrive> soils;     // as Ground::soils()
  std::vector<Vec2> wheels_B_m;     // where they touch level ground: ahead, left
  std::vector<Vec3> underside_B_m;  // of the chassis, over the plane of the wheels' contacts
  DriveLimits limits;
  double turning_radius_min_m = 0;
  bool can_turn_on_spot = true;
  double speed_mps = 1;
};

// What a plan makes as small as can be.
enum class RouteAim {
  energy,  // electrical, of driving
  risk,    // metres, each divided by the share that is left of the limit it comes nearest to
};

}  // namespace lsos
