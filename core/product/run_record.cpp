#include "product/run_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <new>

#include "base/files.h"
#include "base/output_error.h"
#include "base/stop_signal.h"
#include "product/overlay.h"
#include "product/qgis_style.h"

namespace lsos {

namespace {

// Warning for a rover whose slip is missing from the summary though it drove for long; "" for
// others.
std::string slip_warning(const RoverResult& result) {
  constexpr double long_s = 60;
  const bool is_missing = std::isnan(result.slip_p95) && !std::isnan(result.slip_rolling);
  if (!is_missing || result.driven_s < long_s) return "";
  if (result.mean_mps > 0.5 * result.mean_requested_mps) {
    return fmt::format(
        "{}: its slip is not in the summary: it drove {:.2g} m/s, and slip is counted from 0.05 "
        "m/s "
        "or a tenth of the cruise speed on; its wheels slipped by {:.2f} at most, in the mean over "
        "a second",
        result.id, result.mean_mps, result.slip_rolling);
  }
  return fmt::format(
      "{}: its slip is not in the summary: in {:.3g} min of driving it was never faster than half "
      "the requested speed; its wheels slipped by {:.2f} at most, in the mean over a second",
      result.id, result.driven_s / 60, result.slip_rolling);
}

// Warning for a rover that stayed far below its requested speed; "" for others.
std::string slowness_warning(const RoverResult& result) {
  constexpr double long_s = 60, share = 0.5;
  if (!(result.driven_s >= long_s && result.mean_mps < share * result.mean_requested_mps))
    return "";
  return fmt::format(
      "{}: in {:.3g} min of driving it was {:.2g} m/s fast in the mean, where {:.2g} m/s were "
      "asked "
      "for: its motors or the ground allow no more",
      result.id, result.driven_s / 60, result.mean_mps, result.mean_requested_mps);
}

RunSummary summarise(const Simulation& simulation, const MissionModel& files, double wall_s) {
  RunSummary summary;
  // An absolute path, so that files beside the plan are found from any folder.
  summary.plan = std::filesystem::absolute(files.plan.file).lexically_normal().string();
  if (files.from) {
    summary.from = std::filesystem::absolute(files.from->folder).lexically_normal().string();
  }
  summary.start = files.plan.mission.start_time;
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
    rover.max_slip = result.slip_greatest;
    rover.p95_slip = result.slip_p95;
    rover.energy_start_j = result.energy_start_j;
    rover.energy_end_j = result.energy_end_j;
    rover.energy_used_j = result.energy_used_j;
    rover.solar_j = result.solar_j;
    rover.external_j = result.external_j;
    if (!result.resources.empty()) rover.resources = result.resources;
  }
  for (const Fault& fault : files.faults.sorted()) summary.warnings.push_back(to_string(fault));
  for (const std::string& warning : simulation.warnings()) summary.warnings.push_back(warning);
  const std::string left_out = simulation.warnings_left_out();
  if (!left_out.empty()) summary.warnings.push_back(left_out);
  summary.assumptions = files.assumptions;
  for (const std::string& assumption : simulation.assumptions()) {
    summary.assumptions.push_back(assumption);
  }
  return summary;
}

void add_facts_of_log(const std::string& file, RunSummary& summary) {
  const LogReader log(file);
  summary.log_sha256 = log.sha256();
  summary.branch = log.branch();
  summary.days = days_of_long_run(log);
}

// Prepares the folder and returns the name of the log, which must not exist yet.
std::string prepare_log_file(RunFolder& folder, const std::string& plan_bytes) {
  folder.prepare();
  write_file(folder.file("plan.kml"), plan_bytes);
  return folder.file("log.gpkg");
}

// Prepares the folder of a run that goes on, and returns the name of its log.
std::string reopen_log_file(RunFolder& folder) {
  folder.reopen();
  return folder.file("log.gpkg");
}

// Error of making a product; "" when it was made.
std::string product_error(const Product& product, const RunSummary& summary) {
  try {
    product.write(summary);
    return "";
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::exception& error) {
    return error.what();
  }
}

// Writes the summary again with its new warnings; where that fails the earlier one stays.
void rewrite_summary(const std::string& run_dir, const RunSummary& summary) {
  try {
    write_summary(run_dir, summary);
  } catch (const OutputError&) {
  } catch (const InputError&) {
  }
}

}  // namespace

RunRecord::RunRecord(RunFolder& folder, const std::string& plan_bytes, const MissionModel& files,
                     const std::map<std::string, std::string>& run_values,
                     Simulation& simulation) try
    : folder_(folder),
      log_(prepare_log_file(folder, plan_bytes), std::string(files.plan.mission.planet->crs),
           files.plan.mission.start_time) {
  log_.write_run(run_values);
  std::vector<std::string> rovers;
  for (const PlanRover& rover : files.plan.rovers) rovers.push_back(rover.id);
  std::vector<LayerStyle> styles;
  for (const QgisLayer& layer : qgis_layers(rovers)) {
    styles.push_back({std::string(layer.layer), layer.title, qgis_style(layer)});
  }
  log_.write_styles(styles);
  log_.commit();
  folder.settle();
  simulation.set_log(&log_);
} catch (...) {
  // The log is closed by now. An earlier run is put back, as where the disk is full.
  folder.discard();
}

RunRecord::RunRecord(RunFolder& folder, const MissionModel& files, std::int64_t checkpoint_id,
                     Simulation& simulation)
    : folder_(folder), log_(reopen_log_file(folder), files.plan.mission.start_time, checkpoint_id) {
  simulation.set_log(&log_);
}

RunSummary RunRecord::finish(const MissionModel& files, const Simulation& simulation, double wall_s,
                             const std::function<void(const std::string&)>& warn,
                             const std::vector<Product>& more, bool can_resume) {
  const int stopped_before = stop_signal();
  const Task task("the log is closed, and the summary, the overlay and the report are written");
  RunSummary summary = summarise(simulation, files, wall_s);
  for (const RoverResult& result : simulation.results()) {
    for (const std::string& warning : {slip_warning(result), slowness_warning(result)}) {
      if (warning.empty()) continue;
      summary.warnings.push_back(warning);
      warn(warning);
    }
  }
  if (const std::string lost = log_.lost_numbers(); !lost.empty()) {
    summary.warnings.push_back(lost);
    warn(lost);
  }
  // Checkpoints go only once the summary is there: a kill or a full disk before leaves a run that
  // can go on.
  log_.commit();
  add_facts_of_log(folder_.file("log.gpkg"), summary);
  write_summary(folder_.path(), summary);
  const std::size_t warnings_before = summary.warnings.size();
  try {
    log_.finish(can_resume);
  } catch (const LogError& error) {
    // All rows are committed: only the log's write-ahead log or its checkpoints stay.
    summary.warnings.emplace_back(error.what());
    warn(summary.warnings.back());
  }
  const auto make = [&](const Product& product) {
    const int stopped_by = stop_signal();
    const std::string fault = stopped_by == stopped_before
                                  ? product_error(product, summary)
                                  : fmt::format("stopped by {}", name_of_signal(stopped_by));
    if (fault.empty()) return;
    summary.warnings.push_back(fmt::format("{} is missing: {}; lsos-host {} {} makes it again",
                                           folder_.file(product.file), fault, product.command,
                                           folder_.path()));
    warn(summary.warnings.back());
  };
  make({"overlay.kml", "overlay",
        [&](const RunSummary&) { write_overlay(folder_.path(), files.plan); }});
  make({"days.csv", "report", [&](const RunSummary& whole) {
          if (!whole.days.empty()) {
            write_file(folder_.file("days.csv"), days_csv(whole.days, whole.start));
          }
        }});
  std::ranges::for_each(more, make);
  if (summary.warnings.size() > warnings_before) rewrite_summary(folder_.path(), summary);
  return summary;
}

}  // namespace lsos
