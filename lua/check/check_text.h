// Text that `lsos-host check` prints for people.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mission/ahead/route_ahead.h"
#include "mission/model/mission_model.h"

namespace lsos {

// A leg planned before the run, as it is reported.
struct PlannedLegLine {
  std::string rover_id, label;
  std::int64_t sequence = 0, waypoint = 0;
  double length_m = 0, duration_s = 0, energy_j = 0, slope_max_deg = 0;
  double steepest_lon_deg = 0, steepest_lat_deg = 0;
  std::size_t gear_changes = 0;  // between forwards and backwards
  bool is_passed = false;        // the rover stands there already: nothing is planned
};

// Lengths of the line that an event drives as drawn, without planning.
struct DrawnEventLine {
  std::string rover_id, label;
  DrawnLine drawn;
};

struct RoutesAhead {
  std::vector<PlannedLegLine> planned;
  std::vector<DrawnEventLine> drawn;
};

// States whether the plan can be run, then lists warnings, routes, defaults grouped by their
// owners, and the number of assumptions; more than 30 planned legs are summed up by rover.
// `is_verbose`: each leg, default and assumption is on a line of its own. For a plan with errors
// its faults are listed, and that there is no estimate.
std::string check_text(const MissionModel& files, const RoutesAhead& routes, bool is_verbose);

}  // namespace lsos
