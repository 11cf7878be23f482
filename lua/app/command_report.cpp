// `lsos-host report`: writes report.html, or a figure for a paper, from a run's log.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/files.h"
#include "base/output_file.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/opened_run.h"
#include "lua/host/run_mission.h"
#include "product/figure.h"
#include "product/report_run.h"

namespace lsos {

namespace {

struct ReportOptions {
  std::string folder;     // of a run
  std::string file;       // "": DIR/report.html, DIR/report.png
  std::string shadow_at;  // UTC, or a time from the start; "": the start
  bool has_pictures = true;
  bool is_figure = false;  // a PNG for a paper
  std::optional<int> dpi;
  int threads = 2;
  bool is_json = false;
};

struct OpenedRun {
  PictureRun run;
  std::vector<std::string> left_out;
};

// Opens the run. Files that the plan had beside it (scripts, rasters) may have been moved since;
// the run is then opened without its ground.
OpenedRun opened(const std::string& folder, const LogReader& log) {
  OpenedRun opened;
  try {
    opened.run = open_run(folder, log);
    for (const std::string& warning : opened.run.warnings) opened.left_out.push_back(warning);
    return opened;
  } catch (const InputError& error) {
    opened.left_out.push_back(fmt::format("map and pictures: {}", error.what()));
  }
  MissionFiles files = mission_of_run(folder, log.run());
  if (files.plan.mission.planet == nullptr) files.faults.throw_if_errors();
  opened.run.files = std::move(files);
  opened.run.start = log.start();
  opened.run.end = log.last_sample_time();
  return opened;
}

void check(const ReportOptions& options) {
  const std::string& folder = options.folder;
  Faults faults;
  check_output("-o", options.file, {options.is_figure ? ".png" : ".html"},
               {folder + "/plan.kml", folder + "/log.gpkg"}, faults);
  if (!options.is_figure && options.dpi) faults.error({}, "--dpi: only with --png");
  if (options.is_figure && !options.shadow_at.empty()) {
    faults.error({}, "--shadow-at: there is no map in the figure of --png");
  }
  faults.throw_if_errors();
  for (const char* name : {"plan.kml", "log.gpkg"}) {
    if (std::filesystem::is_regular_file(folder + "/" + name)) continue;
    throw InputError({folder}, "no run of lsos-host: plan.kml and log.gpkg are what a run leaves");
  }
}

SimTime shadow_time(const ReportOptions& options, const PictureRun& run) {
  if (options.shadow_at.empty()) return {};
  const SimTime time = time_since_start("--shadow-at", options.shadow_at, run.start);
  if (time >= SimTime{} && time <= run.end) return time;
  throw InputError({}, fmt::format("--shadow-at {}: the run is from {} to {}", options.shadow_at,
                                   format_utc(run.start), format_utc(run.start + run.end)));
}

int report_command(const ReportOptions& options) {
  check(options);
  const std::string& folder = options.folder;
  const LogReader log(folder + "/log.gpkg");
  require_samples(log, folder);
  OpenedRun from = opened(folder, log);
  std::string file = options.file;
  if (options.is_figure) {
    if (file.empty()) file = folder + "/report.png";
    const SiteFrame site =
        from.run.ground ? from.run.ground->site() : site_of(log, from.run.files.plan);
    const int dpi = options.dpi.value_or(figure_dpi);
    write_file(file, figure_png(read_report_data(log, from.run.files.plan, site), dpi));
  } else {
    if (file.empty()) file = folder + "/report.html";
    const ReportRequest request{shadow_time(options, from.run), options.has_pictures,
                                options.threads};
    const std::string summary = read_file(folder + "/summary.json").value_or("");
    write_file(file, report_of(from.run, log, summary, request, from.left_out));
  }
  for (const std::string& what : from.left_out) print_message("warning: {}\n", what);
  if (options.is_json) {
    print_result("{}\n", nlohmann::json{{options.is_figure ? "figure" : "report", file}}.dump());
  } else {
    print_result("{}\n", file);
  }
  return 0;
}

}  // namespace

std::function<int()> prepare_report(CommandOptions& command) {
  const auto options = std::make_shared<ReportOptions>();
  command.add_option("DIR", options->folder, "Folder of a run").required();
  command.add_option("-o,--output", options->file, "DIR/report.html, or with --png DIR/report.png");
  command.add_option("--shadow-at", options->shadow_at,
                     "UTC, or a time from the start: of the shadow on the map (the start)");
  command.add_flag("!--no-pictures", options->has_pictures, "Leave them out");
  command.add_flag("--png", options->is_figure, "Its plots as a figure for a paper");
  command.add_option("--dpi", options->dpi, "Of the figure, 18 cm wide (300)").between(50, 1200);
  add_threads(command, options->threads, "Threads that work on the map");
  command.add_flag("--json", options->is_json, "The name of the file as JSON");
  return [options] { return report_command(*options); };
}

}  // namespace lsos
