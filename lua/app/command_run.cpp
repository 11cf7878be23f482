// `lsos-host run`: reads and checks a plan, simulates it, and leaves the results in a folder.
#include <fmt/format.h>

#include <filesystem>

#include "base/console.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/planning_watch.h"
#include "lua/app/run_to_end.h"
#include "lua/host/cached_routes.h"
#include "lua/host/mission_reader.h"
#include "lua/host/run_from.h"
#include "lua/host/run_values.h"
#include "lua/host/version.h"
#include "plan/kml_text.h"
#include "product/replaced_run.h"

namespace lsos {

int run_files(MissionFiles files, const RunOptions& options,
              std::chrono::steady_clock::time_point begin) {
  const SimTime every = kept_every(options.checkpoints);
  files.faults.throw_if_errors();
  if (!options.from.empty()) begin_from(options.from, files);
  files.faults.throw_if_errors();
  files.faults.add(cached_legs_advice(files.plan.home));
  for (const Fault& fault : files.faults.sorted()) {
    if (!options.is_quiet) print_message("{}\n", to_string(fault));
  }
  const std::string path =
      options.folder.empty() ? default_run_folder(options.plan) : options.folder;
  check_not_from(path, options.from);
  const std::string other =
      check_replaced_run(path, options.plan, options.folder.empty(), options.is_forced);
  RunFolder folder(path, options.is_forced);
  PlanningWatch watch(options.is_quiet);
  SimulationSetup setup = run_setup(files, options, watch);
  setup.save_every_exchange = options.save_every_exchange;
  // The constructor makes the last checks, whether the plan fits the terrain. The old run is
  // removed only after them.
  Simulation simulation(std::move(setup));
  for (const Fault& fault : simulation.advice()) {
    files.faults.add({fault});
    if (!options.is_quiet) print_message("{}\n", to_string(fault));
  }
  if (!options.is_quiet && !simulation.renderer().empty()) {
    print_message("light is drawn by {}\n", simulation.renderer());
  }
  tell_of_replaced_run(path, other);
  // Up to here a signal may end the program at once, as there are no results to write.
  catch_stop_signals();
  const std::map<std::string, std::string> values = run_values(files, simulation);
  RunRecord record(folder, files.plan_bytes, files, values, simulation);
  const auto absolute = [](const std::string& name) {
    return name.empty() ? name : std::filesystem::absolute(name).lexically_normal().string();
  };
  Checkpoints checkpoints(
      record.log(),
      {program_build(), absolute(options.plan), values, every, "", absolute(options.from), ""},
      options.checkpoints.is_on, seconds_since(begin));
  simulation.start();
  checkpoints.start(simulation);
  return run_to_end({files, simulation, folder, record, checkpoints}, options);
}

int run_command(const RunOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  return run_files(read_mission(options.plan, options.seed), options, begin);
}

std::function<int()> prepare_run(CommandOptions& command) {
  const auto options = std::make_shared<RunOptions>();
  command.add_option("PLAN", options->plan, "A plan: KML, KMZ or GeoPackage").required();
  command.add_option("-o,--output", options->folder, "Folder of the results (out/PLAN-NAME)");
  command.add_option("--from", options->from, from_help);
  command.add_flag("--force", options->is_forced,
                   "Replace an unfinished run, or without -o that of another plan");
  add_outcome_options(command, *options);
  add_checkpoint_options(command, options->checkpoints);
  command.add_flag("--watch", options->is_watched,
                   "Run again whenever the plan or a script changes");
  command.add_option("--seed", options->seed, "Instead of the plan's Seed").seed();
  command.add_flag("--save-every-exchange", options->save_every_exchange,
                   "Write all state out and read it back every 0.1 s (a test of resuming)");
  return
      [options] { return options->is_watched ? watch_command(*options) : run_command(*options); };
}

}  // namespace lsos
