// `lsos-host run`: reads and checks a plan, simulates it, and leaves the results in a folder.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/files.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/planning_watch.h"
#include "lua/app/progress.h"
#include "lua/app/run_options.h"
#include "lua/host/cached_routes.h"
#include "lua/host/mission_reader.h"
#include "lua/host/run_values.h"
#include "plan/kml_text.h"
#include "product/qgis_run.h"
#include "product/report_run.h"
#include "product/run_record.h"

namespace lsos {

namespace {

std::atomic<int> stop_signal{0};

// Returns the signal that stopped the run, or 0.
int simulate(Simulation& simulation, bool is_quiet) {
  Progress progress(is_quiet);
  int stopped_by = 0;
  simulation.start();
  while (!simulation.is_finished() && stopped_by == 0) {
    stopped_by = stop_signal;
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

void request_stop(int signal) {
  stop_signal = signal;
  std::signal(signal, SIG_DFL);  // a second signal ends the program at once
}

// File of another plan whose run the folder holds; "" where it holds no run, a run of this plan, or
// a run of a plan that no longer exists.
std::string other_plan_in(const std::string& folder, const std::string& plan) {
  const std::string bytes = read_file(folder + "/summary.json").value_or("");
  const auto summary = nlohmann::json::parse(bytes, nullptr, false);
  if (!summary.is_object() || !summary.contains("plan") || !summary["plan"].is_string()) return "";
  const std::string other = summary["plan"].get<std::string>();
  std::error_code ignored;
  const bool is_other =
      std::filesystem::exists(other, ignored) && !std::filesystem::equivalent(other, plan, ignored);
  return is_other ? other : "";
}

void warn(const std::string& what) { print_message("warning: {}\n", what); }

}  // namespace

int run_command(const RunOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  MissionFiles files = read_mission(options.plan, options.seed);
  files.faults.throw_if_errors();
  files.faults.add(cached_legs_advice(options.plan));
  for (const Fault& fault : files.faults.sorted()) {
    if (!options.is_quiet) print_message("{}\n", to_string(fault));
  }
  const std::string path =
      options.folder.empty() ? default_run_folder(options.plan) : options.folder;
  const std::string other = other_plan_in(path, options.plan);
  // Without this check plans of the same name in two folders would replace each other's results.
  if (!other.empty() && options.folder.empty() && !options.is_forced) {
    throw InputError({path, 0},
                     fmt::format("holds the run of {}, another plan of that name: -o names another "
                                 "folder, --force replaces it",
                                 other));
  }
  RunFolder folder(path, options.is_forced);
  SimulationSetup setup = simulation_setup(files);
  setup.threads = options.threads;
  setup.keeps_sight = true;
  setup.save_every_exchange = options.save_every_exchange;
  PlanningWatch watch(options.is_quiet);
  std::vector<Fault> legs_not_cached;
  setup.cache_legs = [&](const std::string& bytes) {
    legs_not_cached = cache_legs(options.plan, bytes);
  };
  setup.on_planning = [&](const std::string& what) { watch.plan(what); };
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
  // The loss of results is reported even with --quiet.
  if (!other.empty()) print_message("{}: the run of {} that it held is replaced\n", path, other);
  // Up to here a signal may end the program at once, as there are no results to write.
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  RunRecord record(folder, files.plan_bytes, files, run_values(files, simulation), simulation);
  const int stopped_by = simulate(simulation, options.is_quiet);
  legs_not_cached = cache_legs(options.plan, simulation.cached_legs());
  for (const Fault& fault : legs_not_cached) {
    if (!options.is_quiet) print_message("{}\n", to_string(fault));
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  std::vector<Product> products;
  if (options.has_report) {
    products.push_back({"mission.qgz", "report", [&](const RunSummary&) {
                          write_qgis_project(folder.path(), files, simulation.ground());
                        }});
    products.push_back(
        {"report.html", "report", [&](const RunSummary& run_summary) {
           // The report of a stopped run has no pictures, so that the program ends
           // soon.
           const ReportRequest request{{}, stopped_by == 0, std::max(2, options.threads)};
           write_report(folder.path(), files, simulation.ground(), run_summary, request);
         }});
  }
  const RunSummary summary = record.finish(files, simulation, wall.count(), warn, products);

  for (const std::string& warning : simulation.warnings()) {
    if (!options.is_quiet) print_message("warning: {}\n", warning);
  }
  print_result("{}", options.is_json ? to_json(summary) : to_text(summary));
  if (!options.is_json) print_result("results in {}\n", folder.path());
  if (stopped_by != 0) return 128 + stopped_by;
  return summary.status == RunStatus::completed ? 0 : 1;
}

std::function<int()> prepare_run(CommandOptions& command) {
  const auto options = std::make_shared<RunOptions>();
  command.add_option("PLAN", options->plan, "A plan: KML, KMZ or GeoPackage").required();
  command.add_option("-o,--output", options->folder, "Folder of the results (out/PLAN-NAME)");
  command.add_flag("--force", options->is_forced,
                   "Replace an unfinished run, or without -o that of another plan");
  command.add_flag("!--no-report", options->has_report, "No report.html, which takes some seconds");
  command.add_flag("--quiet", options->is_quiet, "No progress");
  command.add_flag("--json", options->is_json, "The summary as JSON");
  command.add_flag("--watch", options->is_watched,
                   "Run again whenever the plan or a script changes");
  add_threads(command, options->threads, "Threads that step rovers");
  command.add_option("--seed", options->seed, "Instead of the plan's Seed").seed();
  command.add_flag("--save-every-exchange", options->save_every_exchange,
                   "Write all state out and read it back every 0.1 s (a test of resuming)");
  return
      [options] { return options->is_watched ? watch_command(*options) : run_command(*options); };
}

}  // namespace lsos
