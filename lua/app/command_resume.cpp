// `lsos-host resume`: goes on with a run that was stopped or killed.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/console.h"
#include "base/files.h"
#include "base/stop_signal.h"
#include "lua/app/commands.h"
#include "lua/app/planning_watch.h"
#include "lua/app/progress.h"
#include "lua/app/run_to_end.h"
#include "lua/app/saved_run.h"
#include "lua/host/mission_reader.h"
#include "lua/host/run_values.h"
#include "lua/host/version.h"

namespace lsos {

namespace {

// Says in the log, and in later checkpoints, that another renderer draws from here on.
void note_renderer(SavedRun& saved, const std::string& renderer, LogWriter& log) {
  const auto before = saved.mission.values.find("renderer");
  if (before == saved.mission.values.end()) return;
  before->second = renderers_text(before->second, renderer, saved.time);
  log.write_run({*before});
}

// The plan in the folder counts. The one that it was made of may have been edited since, which is
// no fault, but may surprise. A branch has a plan of its own.
void tell_of_edited_plan(const std::string& folder, const std::string& plan_file) {
  if (LogReader(folder + "/log.gpkg").branch()) return;
  std::error_code unreadable;
  const std::string goes_on = fmt::format("the run goes on with {}/plan.kml", folder);
  if (!std::filesystem::exists(plan_file, unreadable)) {
    print_message("{}: is gone; {}\n", plan_file, goes_on);
    return;
  }
  try {
    const std::string kept = read_file(folder + "/plan.kml").value_or("");
    if (read_plan_source(plan_file).bytes == kept) return;
  } catch (const InputError&) {
  }
  print_message("{}: has changed since it was run; {}\n", plan_file, goes_on);
}

}  // namespace

int resume_command(const ResumeOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  RunFolder folder = RunFolder::of_run(options.folder);
  const std::vector<CheckpointEntry> entries = resumable_checkpoints(folder.path());
  std::vector<std::string> damaged;
  SavedRun saved = last_saved_run(folder.path(), entries, damaged);
  for (const std::string& what : damaged) print_message("warning: {}\n", what);
  MissionFiles files = files_of_run(folder.path(), saved.mission);
  PlanningWatch watch(options.is_quiet);
  Simulation simulation(run_setup(files, options, watch));
  const Faults differing =
      differences(saved.mission, program_build(), run_values(files, simulation), folder.path(),
                  options.is_renderer_allowed);
  differing.throw_if_errors();
  files.faults.add(simulation.advice());
  files.faults.add(differing.sorted());
  for (const Fault& fault : files.faults.sorted()) {
    if (!options.is_quiet) print_message("{}\n", to_string(fault));
  }
  if (!options.is_quiet) tell_of_edited_plan(folder.path(), saved.mission.plan_file);
  restore(simulation, saved, folder.path());
  catch_stop_signals();
  RunRecord record(folder, files, saved.id, simulation);
  note_renderer(saved, simulation.renderer(), record.log());
  Checkpoints checkpoints(record.log(), saved.mission, true, saved.wall_s + seconds_since(begin));
  checkpoints.go_on(simulation);
  if (!options.is_quiet) {
    print_message("{}: goes on at {} of the mission\n", folder.path(),
                  clock_text(seconds(simulation.now())));
  }
  return run_to_end({files, simulation, folder, record, checkpoints}, options);
}

std::function<int()> prepare_resume(CommandOptions& command) {
  const auto options = std::make_shared<ResumeOptions>();
  command.add_option("DIR", options->folder, "Folder of a run that was stopped or killed")
      .required();
  add_outcome_options(command, *options);
  command.add_flag("--allow-renderer", options->is_renderer_allowed,
                   "Go on although another renderer draws light and sight");
  return [options] { return resume_command(*options); };
}

}  // namespace lsos
