#include "lua/app/run_options.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/quantity.h"
#include "base/units.h"
#include "lua/app/common_options.h"

namespace lsos {

void add_outcome_options(CommandOptions& command, OutcomeOptions& options) {
  command.add_flag("!--no-report", options.has_report, "No report.html, which takes some seconds");
  command.add_flag("!--no-estimate", options.has_estimate,
                   "No estimate beside the results in the report, which takes what check takes");
  command.add_flag("--quiet", options.is_quiet, "No progress");
  command.add_flag("--json", options.is_json, "The summary as JSON");
  add_threads(command, options.threads, "Threads that plan for rovers and step them");
  command.add_option("--log-max", options.log_max_gb,
                     "GB that the log may take, at which the run ends (50)");
}

void add_checkpoint_options(CommandOptions& command, CheckpointOptions& options) {
  command.add_option("--checkpoint-every", options.every,
                     "A duration of the mission, as \"1 d\": keep a checkpoint each time it is "
                     "over, to branch from");
  command.add_flag("!--no-checkpoints", options.is_on,
                   "Write none: a run that is stopped cannot be resumed");
}

SimTime kept_every(const CheckpointOptions& options) {
  if (options.every.empty()) return {};
  const auto refuse = [&](const std::string& why) {
    throw InputError({}, fmt::format("--checkpoint-every {}: {}", options.every, why));
  };
  if (!options.is_on) refuse("--no-checkpoints writes none");
  const Parsed<double> every = parse_quantity(options.every, *find_unit("s"));
  if (!every) refuse(every.why);
  constexpr double least_s = 1, greatest_s = 1e9;
  if (!(*every.value >= least_s && *every.value <= greatest_s)) {
    refuse(fmt::format("{:.3g} s to {:.3g} s are allowed, as in \"1 d\"", least_s, greatest_s));
  }
  return from_seconds(*every.value);
}

}  // namespace lsos
