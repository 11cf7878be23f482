#include "lua/app/run_to_end.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <csignal>

#include "base/console.h"
#include "lua/app/progress.h"
#include "lua/host/cached_routes.h"
#include "product/qgis_run.h"
#include "product/report_run.h"

namespace lsos {

namespace {

std::atomic<int> stop_signal{0};

void request_stop(int signal) {
  stop_signal = signal;
  std::signal(signal, SIG_DFL);  // a second signal ends the program at once
}

void warn(const std::string& what) { print_message("warning: {}\n", what); }

// Returns the signal that stopped the run, or 0.
int simulate(Simulation& simulation, Checkpoints& checkpoints, bool is_quiet) {
  Progress progress(is_quiet, seconds(simulation.now()));
  int stopped_by = 0;
  while (!simulation.is_finished() && stopped_by == 0) {
    stopped_by = stop_signal;
    if (stopped_by != 0) {
      checkpoints.stop(simulation);
      simulation.stop(fmt::format("stopped by {}", stopped_by == SIGINT ? "SIGINT" : "SIGTERM"));
      continue;
    }
    simulation.advance();
    checkpoints.write_if_due(simulation);
    progress.show(simulation.progress(), seconds(simulation.now()));
  }
  progress.finish();
  simulation.terminate();
  return stopped_by;
}

std::vector<Product> products_of(const MissionUnderWay& mission, const OutcomeOptions& options,
                                 bool has_pictures) {
  if (!options.has_report) return {};
  const std::string path = mission.folder.path();
  const MissionFiles& files = mission.files;
  const Ground& ground = mission.simulation.ground();
  const ReportRequest request{{}, has_pictures, std::max(2, options.threads)};
  return {{"mission.qgz", "report",
           [&files, &ground, path](const RunSummary&) { write_qgis_project(path, files, ground); }},
          {"report.html", "report", [&files, &ground, path, request](const RunSummary& summary) {
             write_report(path, files, ground, summary, request);
           }}};
}

}  // namespace

void catch_stop_signals() {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

int run_to_end(MissionUnderWay mission, const OutcomeOptions& options) {
  Simulation& simulation = mission.simulation;
  const int stopped_by = simulate(simulation, mission.checkpoints, options.is_quiet);
  for (const Fault& fault : cache_legs(mission.files.plan.file, simulation.cached_legs())) {
    if (!options.is_quiet) print_message("{}\n", to_string(fault));
  }
  const bool can_resume = stopped_by != 0 && mission.checkpoints.is_on();
  // The report of a stopped run has no pictures, so that the program ends soon.
  const RunSummary summary =
      mission.record.finish(mission.files, simulation, mission.checkpoints.wall_s(), warn,
                            products_of(mission, options, stopped_by == 0), can_resume);
  for (const std::string& warning : simulation.warnings()) {
    if (!options.is_quiet) print_message("warning: {}\n", warning);
  }
  const std::string& folder = mission.folder.path();
  print_result("{}", options.is_json ? to_json(summary) : to_text(summary));
  if (!options.is_json) print_result("results in {}\n", folder);
  if (can_resume) {
    flush_results();
    print_message("stopped: resume with 'lsos-host resume {}'\n", folder);
  }
  if (stopped_by != 0) return 128 + stopped_by;
  return summary.status == RunStatus::completed ? 0 : 1;
}

}  // namespace lsos
