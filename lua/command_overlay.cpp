// `lsos-host overlay`: writes overlay.kml again from a run's log.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "lua/commands.h"
#include "lua/console.h"
#include "lua/run_mission.h"
#include "product/overlay.h"
#include "record/log.h"

namespace lsos {

int overlay_command(const std::string& folder, bool is_packed, bool is_json) {
  const std::string plan_file = folder + "/plan.kml";
  if (!std::filesystem::exists(plan_file) || !std::filesystem::exists(folder + "/log.gpkg")) {
    throw InputError({folder}, "no run of lsos-host: plan.kml and log.gpkg are what a run leaves");
  }
  // The plan passed its checks when it was run; what its folder had beside it (scripts, rasters)
  // may be elsewhere now and is not needed to draw it.
  const LogReader log(folder + "/log.gpkg");
  require_samples(log, folder);
  const MissionFiles files = mission_of_run(folder, log.run());
  if (files.plan.mission.planet == nullptr) files.faults.throw_if_errors();
  for (const Fault& fault : files.faults.sorted()) {
    if (fault.severity != Severity::error) continue;
    print_message("warning: what the plan drew may be incomplete: {}\n", to_string(fault));
  }
  (is_packed ? write_packed_overlay : write_overlay)(folder, files.plan);
  const std::string file = folder + (is_packed ? "/overlay.kmz" : "/overlay.kml");
  if (is_json) {
    print_result("{}\n", nlohmann::json{{"overlay", file}}.dump());
  } else {
    print_result("{}\n", file);
  }
  return 0;
}

}  // namespace lsos
