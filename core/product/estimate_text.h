// The estimate of a mission as `check` shows it: as a table, as JSON, as CSV; and as a run keeps
// it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "mission/mission_estimate.h"

namespace lsos {

// A table with a line an event; of more than 40 events with one a rover and day of the mission, or
// several days, unless `is_verbose`. Times are day and clock since the start; the day counts from
// 1.
std::string estimate_text(const MissionEstimate& estimate, bool is_verbose);
// An array, an object an event; null where something cannot be known.
nlohmann::ordered_json estimate_json(const MissionEstimate& estimate);

// The same as a table with a heading; cells of what cannot be known are empty, shares have a column
// for either end.
std::string estimate_csv(const MissionEstimate& estimate, Instant mission_start);

// What a run's folder has of its estimate, for the report: an object with `events`, as above, and
// `days`, an object a rover and day.
inline constexpr const char* estimate_file = "estimate.json";
std::string estimate_file_text(const MissionEstimate& estimate);

}  // namespace lsos
