#include "lua/app/run_to_end.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <set>
#include <string>

#include "base/console.h"
#include "lua/app/progress.h"
#include "lua/check/run_estimate.h"
#include "lua/host/cached_routes.h"
#include "lua/host/mission_reader.h"
#include "product/estimate_text.h"
#include "product/qgis_run.h"
#include "product/report_run.h"

namespace lsos {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

std::atomic<int> stop_signal{0};

void request_stop(int signal) {
  stop_signal = signal;
  std::signal(signal, SIG_DFL);  // a second signal ends the program at once
}

void warn(const std::string& what) { print_message("warning: {}\n", what); }

// What a run says while it goes on, so that a failure of the third day need not be waited for.
class RunNews {
 public:
  explicit RunNews(bool is_quiet) : is_quiet_(is_quiet) {}

  // Prints warnings and events that have failed since the last call.
  void tell(const Simulation& simulation, Progress& progress) {
    if (is_quiet_) return;
    const std::vector<std::string>& warnings = simulation.warnings();
    const std::size_t ended = simulation.fleet().events_ended();
    if (warnings_ == warnings.size() && ended_ == ended) return;
    progress.finish();
    for (; warnings_ < warnings.size(); ++warnings_) {
      print_message("warning: {}\n", warnings[warnings_]);
    }
    if (ended_ == ended) return;
    ended_ = ended;
    for (const EventRow& event : simulation.events()) {
      if (event.status != EventStatus::failed || !event.end) continue;
      if (!failed_.insert(fmt::format("{}/{}", event.rover_id, event.sequence)).second) continue;
      print_message("{} at {}: {} '{}' failed: {}\n", event.rover_id,
                    clock_text(seconds(*event.end)), event.type, event.label, event.reason);
    }
  }

 private:
  bool is_quiet_;
  std::size_t warnings_ = 0, ended_ = 0;  // told, and seen to have ended
  std::set<std::string> failed_;          // told, "ROVER/SEQUENCE"
};

// The rovers that move, and the day of a mission longer than one.
std::string doing_text(const Simulation& simulation, double expected_end_s) {
  constexpr double day_s = 86400;
  const std::vector<std::string> moving = simulation.moving_rovers();
  std::string text =
      expected_end_s > day_s
          ? fmt::format("day {}: ", 1 + static_cast<int>(seconds(simulation.now()) / day_s))
          : "";
  if (moving.empty()) return text + "all stand";
  return text + fmt::format("{} move{}", fmt::join(moving, ", "), moving.size() == 1 ? "s" : "");
}

void show(const Simulation& simulation, const TimeLeft& time_left, double wall_s,
          Progress& progress) {
  if (!progress.is_due()) return;
  const double now_s = seconds(simulation.now());
  const MissionWork work = simulation.work();
  const std::optional<double> left_s = time_left.left_s(work, now_s);
  const double share = left_s ? wall_s / (wall_s + *left_s) : simulation.progress();
  progress.show_mission(share, now_s, left_s, doing_text(simulation, work.stand_until_s));
}

// Returns the signal that stopped the run, or 0.
int simulate(Simulation& simulation, Checkpoints& checkpoints, bool is_quiet) {
  Progress progress(is_quiet, seconds(simulation.now()));
  RunNews news(is_quiet);
  TimeLeft time_left(simulation.work());
  const Clock::time_point begin = Clock::now();
  Clock::time_point step = begin;
  int stopped_by = 0;
  while (!simulation.is_finished() && stopped_by == 0) {
    stopped_by = stop_signal;
    if (stopped_by != 0) {
      checkpoints.stop(simulation);
      simulation.stop(fmt::format("stopped by {}", stopped_by == SIGINT ? "SIGINT" : "SIGTERM"));
      continue;
    }
    const double before_s = seconds(simulation.now());
    const bool drives = !simulation.is_at_rest();
    simulation.advance();
    checkpoints.write_if_due(simulation);
    const Clock::time_point now = Clock::now();
    time_left.add(seconds_between(step, now), seconds(simulation.now()) - before_s, drives);
    step = now;
    news.tell(simulation, progress);
    show(simulation, time_left, seconds_between(begin, now), progress);
  }
  progress.finish();
  simulation.terminate();
  news.tell(simulation, progress);
  return stopped_by;
}

std::vector<Product> products_of(const MissionUnderWay& mission, const OutcomeOptions& options,
                                 bool has_ended) {
  if (!options.has_report) return {};
  const std::string path = mission.folder.path();
  const MissionFiles& files = mission.files;
  const Ground& ground = mission.simulation.ground();
  const ReportRequest request{{}, has_ended, std::max(2, options.threads)};
  std::vector<Product> products;
  if (options.has_estimate && has_ended) {
    const std::string legs = mission.simulation.cached_legs();
    products.push_back({estimate_file, "report", [&files, path, legs, request](const RunSummary&) {
                          write_run_estimate(path, files, legs, request.threads);
                        }});
  }
  products.push_back({"mission.qgz", "report", [&files, &ground, path](const RunSummary&) {
                        write_qgis_project(path, files, ground);
                      }});
  products.push_back(
      {"report.html", "report", [&files, &ground, path, request](const RunSummary& summary) {
         write_report(path, files, ground, summary, request);
       }});
  return products;
}

}  // namespace

void catch_stop_signals() {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

SimulationSetup run_setup(const MissionFiles& files, const OutcomeOptions& options,
                          PlanningWatch& watch) {
  SimulationSetup setup = simulation_setup(files);
  setup.threads = options.threads;
  setup.keeps_sight = true;
  setup.cache_legs = [file = files.plan.home](const std::string& bytes) {
    cache_legs(file, bytes);
  };
  setup.on_planning = [&watch](const std::string& what) { watch.plan(what); };
  return setup;
}

int run_to_end(MissionUnderWay mission, const OutcomeOptions& options) {
  Simulation& simulation = mission.simulation;
  const int stopped_by = simulate(simulation, mission.checkpoints, options.is_quiet);
  for (const Fault& fault : cache_legs(mission.files.plan.home, simulation.cached_legs())) {
    if (!options.is_quiet) print_message("{}\n", to_string(fault));
  }
  const bool can_resume = stopped_by != 0 && mission.checkpoints.is_on();
  // The report of a stopped run has no pictures, so that the program ends soon.
  const RunSummary summary =
      mission.record.finish(mission.files, simulation, mission.checkpoints.wall_s(), warn,
                            products_of(mission, options, stopped_by == 0), can_resume);
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
