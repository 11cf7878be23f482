// The results of a run: summary.json for programs, a page of text for people.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "planet/utc.h"
#include "product/rover_days.h"
#include "record/checkpoint.h"
#include "record/rows.h"

namespace lsos {

enum class RunStatus { completed, failed, incomplete };
const char* to_string(RunStatus status);

// incomplete if an event is incomplete, running or waiting, or has not started though no failure
// prevented it (EventRow::is_prevented); otherwise failed if an event failed; otherwise completed.
RunStatus run_status(std::span<const EventRow> events);

// NaN means not modelled, null in the file.
struct RoverSummary {
  double distance_m = 0;
  double duration_s = 0;  // to the end of its last event
  double drive_s = 0;     // time spent faster than 1 mm/s
  double energy_start_j = not_modelled;
  double energy_end_j = not_modelled;
  double energy_used_j = not_modelled;
  double solar_j = not_modelled;
  double external_j = not_modelled;        // from outside, including levels that were set
  double elevation_gain_m = not_modelled;  // sum of rises, 0.5 m hysteresis
  double max_slope_rad = not_modelled;     // over all exchanges
  double max_slip = not_modelled;          // while driving: greatest mean over a second
  double p95_slip = not_modelled;          // not exceeded during 95 % of that time
  std::optional<std::map<std::string, double>> resources;  // amount left of each
};

struct RunSummary {
  RunStatus status = RunStatus::completed;
  std::string plan;  // its file, as the user named it
  std::string from;  // folder of the run with whose end it begins; "": none
  Instant start;     // of the mission
  std::string log_sha256;
  double sim_s = 0;
  double wall_s = 0;
  std::map<std::string, RoverSummary> rovers;
  std::vector<RoverDay> days;  // of a mission longer than a day
  std::vector<EventRow> events;
  std::vector<std::string> warnings;
  std::vector<std::string> assumptions;  // simplifications of the models
  std::optional<BranchOrigin> branch;    // where it left another run; absent: it is no branch
};

// UTF-8; invalid bytes become U+FFFD.
std::string to_json(const RunSummary& summary);

// Fits one screen: with many events only those that did not complete are listed.
std::string to_text(const RunSummary& summary);

// Writes DIR/summary.json, which marks the run as finished: the log must be complete before it.
// Products made from the log come after it.
void write_summary(const std::string& run_dir, const RunSummary& summary);

// Whether the text is a summary of a finished run, with the parts that this program writes, each of
// its type: what says so may be read without further checks.
bool is_summary(std::string_view json);

}  // namespace lsos
