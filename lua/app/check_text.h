// What `lsos-host check` says to people.
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
  bool is_passed = false;  // the rover stands there already: nothing is planned
};

// What an event drives as drawn.
struct DrawnEventLine {
  std::string rover_id, label;
  DrawnLine drawn;
};

struct WaysAhead {
  std::vector<PlannedLegLine> planned;
  std::vector<DrawnEventLine> drawn;
};

// First whether the plan can be run, then warnings, ways, defaults by what they are of, and
// how many assumptions there are; `is_verbose`: each default and assumption on a line of its own.
// Of a plan with errors its faults alone.
std::string check_text(const MissionModel& files, const WaysAhead& ways, bool is_verbose);

}  // namespace lsos
