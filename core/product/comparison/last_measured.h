// What telemetry says of rovers at a moment: each one's last measured place, heading and charge.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mission/model/measured_state.h"
#include "planet/site_frame.h"
#include "product/comparison/telemetry.h"

namespace lsos {

struct LastMeasured {
  MeasuredState state;
  int line = 0;   // of the last row that something was taken from
  SimTime age{};  // of the oldest value taken
};

struct MeasuredStates {
  std::map<std::string, LastMeasured> rovers;  // by id; those with something measured by then
  std::vector<Fault> warnings;  // values that are old, rovers without any, rows that cannot be used
};

// The last values at or before `moment`; a place as lon_deg and lat_deg, or x_m and y_m of `site`.
// `rover_ids`: of the run. Throws InputError where there is nothing of any rover.
MeasuredStates last_measured(const Telemetry& telemetry, SimTime moment,
                             const std::vector<std::string>& rover_ids, const SiteFrame& site);

}  // namespace lsos
