// What a run came to: summary.json for programs, a page of text for people.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "planet/utc.h"
#include "record/rows.h"

namespace lsos {

enum class RunStatus { completed, failed, incomplete };
const char* to_string(RunStatus status);

// incomplete: an event is incomplete (or still runs or waits), or has not started though no failure
// prevented it (EventRow::is_prevented); else failed: an event failed; else completed.
RunStatus run_status(std::span<const EventRow> events);

// NaN: not modelled, null in the file.
struct RoverSummary {
  double distance_m = 0;
  double duration_s = 0;  // to the end of its last event
  double drive_s = 0;     // faster than 1 mm/s
  double energy_start_j = not_modelled;
  double energy_end_j = not_modelled;
  double energy_used_j = not_modelled;
  double solar_j = not_modelled;
  double external_j = not_modelled;        // from outside, levels that were set among it
  double elevation_gain_m = not_modelled;  // sum of rises, 0.5 m hysteresis
  double max_slope_rad = not_modelled;     // over all exchanges
  double max_slip = not_modelled;          // of driving: greatest mean over a second
  double p95_slip = not_modelled;          // and what 95 % of that time does not exceed
  std::optional<std::map<std::string, double>> resources;  // what is left of each
};

struct RunSummary {
  RunStatus status = RunStatus::completed;
  std::string plan;  // its file, as the user named it
  Instant start;     // of the mission
  std::string log_sha256;
  double sim_s = 0;
  double wall_s = 0;
  std::map<std::string, RoverSummary> rovers;
  std::vector<EventRow> events;
  std::vector<std::string> warnings;
  std::vector<std::string> assumptions;  // what the models leave out
};

// UTF-8; bytes that are none become U+FFFD.
std::string to_json(const RunSummary& summary);

// At most a screen: with many events only those that did not complete.
std::string to_text(const RunSummary& summary);

// Writes DIR/summary.json, which says that the run is finished: before it the log must be whole.
// What is made of the log comes after it.
void write_summary(const std::string& run_dir, const RunSummary& summary);

// The text is a summary that we wrote of a finished run.
bool is_summary(std::string_view json);

}  // namespace lsos
