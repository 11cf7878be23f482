// `lsos-host run`: reads, checks, simulates, and leaves the results in a folder.
#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>

#include "lua/commands.h"
#include "lua/mission_files.h"
#include "lua/progress.h"
#include "plan/kml_text.h"
#include "product/files.h"
#include "product/overlay.h"
#include "product/run_folder.h"
#include "product/summary.h"

namespace lsos {

namespace {

std::atomic<int> asked_to_stop{0};

RunSummary summarise(const Simulation& simulation, const MissionFiles& files, double wall_s) {
  RunSummary summary;
  summary.plan = files.plan.file;
  summary.events = simulation.events();
  summary.status = run_status(summary.events);
  summary.sim_s = seconds(simulation.now());
  summary.wall_s = wall_s;
  for (const RoverResult& result : simulation.results()) {
    RoverSummary& rover = summary.rovers[result.id];
    rover.distance_m = result.distance_m;
    rover.duration_s = result.duration_s;
    rover.drive_s = result.drive_s;
    rover.elevation_gain_m = result.elevation_gain_m;
    rover.max_slope_rad = result.slope_max_rad;
    rover.max_slip = result.slip_max;
    rover.energy_start_j = result.energy_start_j;
    rover.energy_end_j = result.energy_end_j;
    rover.energy_used_j = result.energy_used_j;
    rover.solar_j = result.solar_j;
    if (!result.resources.empty()) rover.resources = result.resources;
  }
  for (const Fault& fault : files.faults.sorted()) summary.warnings.push_back(to_string(fault));
  for (const std::string& warning : simulation.warnings()) summary.warnings.push_back(warning);
  summary.assumptions = files.assumptions;
  for (const std::string& assumption : simulation.assumptions()) {
    summary.assumptions.push_back(assumption);
  }
  return summary;
}

// Answers the signal that stopped it, or 0.
int simulate(Simulation& simulation, bool is_quiet) {
  Progress progress(is_quiet);
  int stopped_by = 0;
  simulation.start();
  while (!simulation.is_finished() && stopped_by == 0) {
    stopped_by = asked_to_stop;
    if (stopped_by != 0) {
      simulation.stop(fmt::format("stopped by {}", stopped_by == SIGINT ? "SIGINT" : "SIGTERM"));
      continue;
    }
    simulation.advance();
    progress.show(simulation.progress(), seconds(simulation.now()));
  }
  progress.finish();
  simulation.terminate();
  return stopped_by;
}

void ask_to_stop(int signal) {
  asked_to_stop = signal;
  std::signal(signal, SIG_DFL);  // who asks again does not want to wait
}

}  // namespace

int run_command(const RunOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  MissionFiles files = read_mission(options.plan, options.seed);
  files.faults.throw_if_errors();
  for (const Fault& fault : files.faults.sorted()) {
    if (!options.is_quiet) fmt::print(stderr, "{}\n", to_string(fault));
  }
  RunFolder folder(options.folder.empty() ? default_run_folder(options.plan) : options.folder,
                   options.is_forced);
  SimulationSetup setup = simulation_setup(files);
  setup.threads = options.threads;
  setup.keeps_sight = true;
  setup.save_every_exchange = options.save_every_exchange;
  // The last checks: whether the plan fits the terrain. Only then the old run may go.
  Simulation simulation(std::move(setup));
  keep_legs(options.plan, simulation.kept_legs());
  for (const Fault& fault : simulation.advice()) {
    files.faults.add({fault});
    if (!options.is_quiet) fmt::print(stderr, "{}\n", to_string(fault));
  }
  if (!options.is_quiet && !simulation.renderer().empty()) {
    fmt::print(stderr, "light is drawn by {}\n", simulation.renderer());
  }
  const std::string plan_bytes = read_bytes(options.plan);  // it may lie in the folder itself
  // Until here a signal may end it at once: there is nothing to write out.
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  folder.prepare();
  write_file(folder.file("plan.kml"), plan_bytes);
  LogWriter log(folder.file("log.gpkg"), std::string(files.plan.mission.planet->crs),
                files.plan.mission.start_time);
  log.write_run(run_values(files, simulation));
  simulation.set_log(&log);
  const int stopped_by = simulate(simulation, options.is_quiet);
  log.finish();
  keep_legs(options.plan, simulation.kept_legs());

  const double wall_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  RunSummary summary = summarise(simulation, files, wall_s);
  summary.log_sha256 = LogReader(folder.file("log.gpkg")).sha256();
  write_overlay(folder.path(), files.plan);
  write_summary(folder.path(), summary);

  for (const std::string& warning : simulation.warnings()) {
    if (!options.is_quiet) fmt::print(stderr, "warning: {}\n", warning);
  }
  fmt::print("{}", options.is_json ? to_json(summary) : to_text(summary));
  if (!options.is_json) fmt::print("results in {}\n", folder.path());
  if (stopped_by != 0) return 128 + stopped_by;
  return summary.status == RunStatus::completed ? 0 : 1;
}

}  // namespace lsos
