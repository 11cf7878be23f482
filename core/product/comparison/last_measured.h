// What telemetry says of rovers at a moment: each one's last measured place, heading and charge.
#pragma once

#include <functional>
#include <map>
#include <optional>
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

// Where x_m, y_m and z_m are measured.
struct MeasuredGround {
  const SiteFrame* site = nullptr;
  std::function<std::optional<double>(const Geodetic&)> height_m;  // of the ground; absent: none
};

// The last values at or before `moment`; a place as lon_deg and lat_deg, or x_m and y_m, with or
// without z_m. `rover_ids`: of the run. Throws InputError where there is nothing of any rover.
MeasuredStates last_measured(const Telemetry& telemetry, SimTime moment,
                             const std::vector<std::string>& rover_ids,
                             const MeasuredGround& ground);

}  // namespace lsos
