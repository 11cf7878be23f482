// Totals and extremes of one rover over the mission.
#pragma once

#include <map>
#include <string>

#include "mission/fleet/fleet.h"

namespace lsos {

struct RoverResult {
  std::string id;
  double distance_m = 0;
  double duration_s = 0;  // until the end of its last event
  double drive_s = 0;
  double elevation_gain_m = 0;
  double slope_max_rad = not_modelled;
  double slip_greatest = not_modelled, slip_p95 = not_modelled;  // while driving, see DriveSlip
  double slip_rolling = not_modelled, driven_s = 0;              // see DriveSlip
  double mean_mps = not_modelled, mean_requested_mps = not_modelled;
  double energy_start_j = not_modelled, energy_end_j = not_modelled;
  double energy_used_j = not_modelled, solar_j = not_modelled, external_j = not_modelled;
  std::map<std::string, double> resources = {};
};

RoverResult result_of(const FleetRover& rover);

}  // namespace lsos
