// `lsos-host resume`: goes on with a run that was stopped or killed.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/console.h"
#include "lua/app/commands.h"
#include "lua/app/planning_watch.h"
#include "lua/app/progress.h"
#include "lua/app/run_to_end.h"
#include "lua/app/saved_run.h"
#include "lua/host/cached_routes.h"
#include "lua/host/mission_reader.h"
#include "lua/host/run_values.h"
#include "lua/host/version.h"

namespace lsos {

namespace {

struct ResumeOptions : OutcomeOptions {
  std::string folder;
  bool is_renderer_allowed = false;
};

// Says in the log that another renderer draws from here on.
void note_renderer(SavedRun& saved, const std::string& renderer, LogWriter& log) {
  const auto before = saved.mission.values.find("renderer");
  if (before == saved.mission.values.end() || before->second == renderer) return;
  log.write_run({{"renderer", fmt::format("{}, from {:.6g} s on {}", before->second,
                                          seconds(saved.time), renderer)}});
  before->second = renderer;
}

int resume_command(const ResumeOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  RunFolder folder = RunFolder::of_run(options.folder);
  const std::vector<CheckpointEntry> entries = resumable_checkpoints(folder.path());
  std::vector<std::string> damaged;
  SavedRun saved = last_saved_run(folder.path(), entries, damaged);
  for (const std::string& what : damaged) print_message("warning: {}\n", what);
  MissionFiles files = files_of_run(folder.path(), saved.mission);
  PlanningWatch watch(options.is_quiet);
  SimulationSetup setup = simulation_setup(files);
  setup.threads = options.threads;
  setup.keeps_sight = true;
  setup.cache_legs = [&](const std::string& bytes) { cache_legs(files.plan.file, bytes); };
  setup.on_planning = [&](const std::string& what) { watch.plan(what); };
  Simulation simulation(std::move(setup));
  const Faults differing = differences(
      saved.mission, {program_build(), "", run_values(files, simulation), {}, "", "", ""},
      folder.path(), options.is_renderer_allowed);
  differing.throw_if_errors();
  files.faults.add(simulation.advice());
  files.faults.add(differing.sorted());
  for (const Fault& fault : files.faults.sorted()) {
    if (!options.is_quiet) print_message("{}\n", to_string(fault));
  }
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

}  // namespace

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
