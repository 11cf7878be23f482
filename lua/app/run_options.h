// What `lsos-host run` is told, once and with --watch, and what it shares with `resume` and
// `branch`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/sim_time.h"
#include "lua/app/command_options.h"

namespace lsos {

// How a run ends, and what it says.
struct OutcomeOptions {
  bool is_quiet = false;
  bool is_json = false;
  bool has_report = true;    // report.html
  bool has_estimate = true;  // beside the results in the report
  int threads = 1;
  double log_max_gb = 50;  // greatest size of log.gpkg
};
void add_outcome_options(CommandOptions& command, OutcomeOptions& options);

// Which checkpoints a run writes.
struct CheckpointOptions {
  bool is_on = true;
  std::string every;  // mission time between those that are kept; "": none are
};
void add_checkpoint_options(CommandOptions& command, CheckpointOptions& options);
// Mission time between kept checkpoints, 0 for none. Throws InputError.
SimTime kept_every(const CheckpointOptions& options);

struct RunOptions : OutcomeOptions {
  std::string plan;
  std::string folder;                 // "": out/PLAN-NAME
  std::string from;                   // folder of the run with whose end it begins; "": none
  bool is_forced = false;             // replace an unfinished run
  std::optional<std::uint64_t> seed;  // instead of the plan's
  bool save_every_exchange = false;
  bool is_watched = false;  // run again whenever the plan or a script changes
  CheckpointOptions checkpoints;
};
int run_command(const RunOptions& options);
// Runs it again each time that the plan or a script changes, until a signal comes.
int watch_command(RunOptions options);

struct ResumeOptions : OutcomeOptions {
  std::string folder;
  bool is_renderer_allowed = false;
};
int resume_command(const ResumeOptions& options);

}  // namespace lsos
