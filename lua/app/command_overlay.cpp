// `lsos-host overlay`: writes overlay.kml again from a run's log.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "lua/app/commands.h"
#include "lua/host/run_mission.h"
#include "product/overlay.h"
#include "record/log.h"

namespace lsos {

namespace {

struct OverlayOptions {
  std::string folder;      // of a run
  bool is_packed = false;  // as KMZ
  bool is_json = false;
};

int overlay_command(const OverlayOptions& options) {
  const std::string& folder = options.folder;
  const std::string plan_file = folder + "/plan.kml";
  if (!std::filesystem::exists(plan_file) || !std::filesystem::exists(folder + "/log.gpkg")) {
    throw InputError({folder}, "no run of lsos-host: plan.kml and log.gpkg are what a run leaves");
  }
  // The plan passed its checks when it was run. Files that it had beside it (scripts, rasters) may
  // have been moved since, and are not needed to draw it.
  const LogReader log(folder + "/log.gpkg");
  require_samples(log, folder);
  const MissionFiles files = mission_of_run(folder, log.run());
  if (files.plan.mission.planet == nullptr) files.faults.throw_if_errors();
  for (const Fault& fault : files.faults.sorted()) {
    if (fault.severity != Severity::error) continue;
    print_message("warning: what the plan drew may be incomplete: {}\n", to_string(fault));
  }
  (options.is_packed ? write_packed_overlay : write_overlay)(folder, files.plan);
  const std::string file = folder + (options.is_packed ? "/overlay.kmz" : "/overlay.kml");
  if (options.is_json) {
    print_result("{}\n", nlohmann::json{{"overlay", file}}.dump(
                             -1, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    print_result("{}\n", file);
  }
  return 0;
}

}  // namespace

std::function<int()> prepare_overlay(CommandOptions& command) {
  const auto options = std::make_shared<OverlayOptions>();
  command.add_option("DIR", options->folder, "Folder of a run").required();
  command.add_flag("--kmz", options->is_packed,
                   "Write overlay.kmz instead, a tenth of the size and with its icons");
  command.add_flag("--json", options->is_json, "The name of the file as JSON");
  return [options] { return overlay_command(*options); };
}

}  // namespace lsos
