// `lsos-host report`: writes report.html, or a figure for a paper, from a run's log, or one page of
// several runs.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/files.h"
#include "base/output_file.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/opened_run.h"
#include "lua/check/run_estimate.h"
#include "lua/host/run_mission.h"
#include "product/comparison/several_runs.h"
#include "product/comparison/several_runs_page.h"
#include "product/estimate_text.h"
#include "product/figure.h"
#include "product/report_run.h"
#include "product/rover_days.h"

namespace lsos {

namespace {

struct ReportOptions {
  std::vector<std::string> folders;  // of runs; with several, the first is the one compared with
  std::string file;                  // "": DIR/report.html, DIR/report.png
  std::string shadow_at;             // UTC, or a time from the start; "": the start
  bool has_pictures = true;
  bool has_estimate = true;  // made where the run has none
  bool is_figure = false;    // a PNG for a paper
  std::optional<int> dpi;
  int threads = 2;
  bool is_json = false;
};

void check_several(const ReportOptions& options, Faults& faults) {
  if (options.folders.size() > runs_max) {
    faults.error({}, fmt::format("{} runs: at most {} fit over each other", options.folders.size(),
                                 runs_max));
  }
  if (options.file.empty()) {
    faults.error({}, "-o FILE.html: is required where a page shows several runs");
  }
  if (options.is_figure) faults.error({}, "--png: only of one run");
}

void check_report(const ReportOptions& options) {
  Faults faults;
  std::vector<std::string> inputs;
  for (const std::string& folder : options.folders) {
    inputs.push_back(folder + "/plan.kml");
    inputs.push_back(folder + "/log.gpkg");
  }
  check_output("-o", options.file, {options.is_figure ? ".png" : ".html"}, inputs, faults);
  if (options.folders.size() > 1) check_several(options, faults);
  if (!options.is_figure && options.dpi) faults.error({}, "--dpi: only with --png");
  if (options.is_figure && !options.shadow_at.empty()) {
    faults.error({}, "--shadow-at: there is no map in the figure of --png");
  }
  faults.throw_if_errors();
  for (const std::string& folder : options.folders) {
    for (const char* name : {"plan.kml", "log.gpkg"}) {
      if (std::filesystem::is_regular_file(folder + "/" + name)) continue;
      faults.error({folder}, "no run of lsos-host: plan.kml and log.gpkg are what a run leaves");
      break;
    }
  }
  faults.throw_if_errors();
}

SimTime shadow_time(const ReportOptions& options, const PictureRun& run) {
  if (options.shadow_at.empty()) return {};
  const SimTime time = time_since_start("--shadow-at", options.shadow_at, run.start);
  if (time >= SimTime{} && time <= run.end) return time;
  throw InputError({}, fmt::format("--shadow-at {}: the run is from {} to {}", options.shadow_at,
                                   format_utc(run.start), format_utc(run.start + run.end)));
}

void print_answer(const ReportOptions& options, const std::string& file,
                  const std::vector<std::string>& left_out) {
  for (const std::string& what : left_out) print_message("warning: {}\n", what);
  if (options.is_json) {
    print_result("{}\n", nlohmann::json{{options.is_figure ? "figure" : "report", file}}.dump(
                             -1, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    print_result("{}\n", file);
  }
}

// Text of the run's estimate, "" where it cannot be made. One that is made is kept with the run,
// but not where the page goes elsewhere: that leaves the run as it is.
std::string estimate_of(const ReportOptions& options, const std::string& folder,
                        const LogReader& log, std::vector<std::string>& left_out) {
  if (!options.has_estimate) return "";
  const std::string file = folder + "/" + estimate_file;
  const std::string text = read_file(file).value_or("");
  if (nlohmann::json::accept(text)) return text;
  try {
    const std::string made = run_estimate_again(folder, log, options.threads);
    if (options.file.empty()) write_file(file, made);
    return made;
  } catch (const std::exception& error) {
    left_out.push_back(fmt::format("the estimate: {}", error.what()));
    return "";
  }
}

int report_several(const ReportOptions& options) {
  std::vector<std::unique_ptr<LogReader>> logs;
  std::vector<RunOfPage> runs;
  std::vector<std::string> left_out;
  for (const std::string& folder : options.folders) {
    logs.push_back(std::make_unique<LogReader>(folder + "/log.gpkg"));
    const LogReader& log = *logs.back();
    require_samples(log, folder);
    const bool is_first = runs.empty();
    LoggedMission from = is_first ? open_run_or_log(folder, log) : open_without_ground(folder, log);
    if (is_first) left_out = from.left_out;
    runs.push_back(
        {folder, &log, read_file(folder + "/summary.json").value_or(""), std::move(from.run)});
  }
  const ReportRequest request{shadow_time(options, runs.front().opened), false, options.threads};
  write_file(options.file, several_runs_page(std::move(runs), request, left_out));
  print_answer(options, options.file, left_out);
  return 0;
}

int report_command(const ReportOptions& options) {
  check_report(options);
  if (options.folders.size() > 1) return report_several(options);
  const std::string& folder = options.folders.front();
  const LogReader log(folder + "/log.gpkg");
  require_samples(log, folder);
  LoggedMission from = open_run_or_log(folder, log);
  std::string file = options.file;
  if (options.is_figure) {
    if (file.empty()) file = folder + "/report.png";
    const SiteFrame site =
        from.run.ground ? from.run.ground->site() : site_of(log, from.run.files.plan);
    const int dpi = options.dpi.value_or(figure_dpi);
    write_file(file, figure_png(read_report_data(log, from.run.files.plan, site), dpi));
  } else {
    if (file.empty()) {
      file = folder + "/report.html";
      write_days(folder);
    }
    const SimTime shadow_at = shadow_time(options, from.run);
    const ReportRequest request{shadow_at, options.has_pictures, options.threads,
                                estimate_of(options, folder, log, from.left_out)};
    const std::string summary = read_file(folder + "/summary.json").value_or("");
    write_file(file, report_of(from.run, log, summary, request, from.left_out));
  }
  print_answer(options, file, from.left_out);
  return 0;
}

}  // namespace

std::function<int()> prepare_report(CommandOptions& command) {
  const auto options = std::make_shared<ReportOptions>();
  command
      .add_option("DIR", options->folders,
                  "Folder of a run; with several, one page shows them over each other")
      .required();
  command.add_option("-o,--output", options->file, "DIR/report.html, or with --png DIR/report.png");
  command.add_option("--shadow-at", options->shadow_at,
                     "UTC, or a time from the start: of the shadow on the map (the start)");
  command.add_flag("!--no-pictures", options->has_pictures, "Leave them out");
  command.add_flag("!--no-estimate", options->has_estimate,
                   "Not beside the results; a run that has none gets one, as by check");
  command.add_flag("--png", options->is_figure, "Its plots as a figure for a paper");
  command.add_option("--dpi", options->dpi, "Of the figure, 18 cm wide (300)").between(50, 1200);
  add_threads(command, options->threads, "Threads that work on the map");
  command.add_flag("--json", options->is_json, "The name of the file as JSON");
  return [options] { return report_command(*options); };
}

}  // namespace lsos
