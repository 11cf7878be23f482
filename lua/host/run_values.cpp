#include "lua/host/run_values.h"

#include <fmt/format.h>

#include "lua/host/script_use.h"
#include "lua/host/version.h"

namespace lsos {

std::map<std::string, std::string> run_values(const MissionFiles& files,
                                              const Simulation& simulation) {
  const MissionInfo& mission = files.plan.mission;
  std::map<std::string, std::string> values{
      {"program", "lsos-host"},
      {"program_version", program_version},
      {"plan_sha256", files.plan.hash()},
      {"seed", std::to_string(mission.seed)},
      {"planet", std::string(mission.planet->name)},
      {"start_time", format_utc(mission.start_time)},
      {"log_interval_s", fmt::format("{}", seconds(mission.log_interval))},
      {"parked_log_interval_s", fmt::format("{}", seconds(mission.parked_log_interval))},
      {"terrain", files.terrain.name},
      {"terrain_sha256", simulation.ground().hash()},
      {"soil", files.terrain.soil.name},
  };
  if (files.terrain.beyond) values["terrain_beyond"] = files.terrain.beyond->name;
  if (!simulation.renderer().empty()) values["renderer"] = simulation.renderer();
  const ScriptUse use(*files.catalog, files.plan, files.terrain);
  for (const Script& script : files.catalog->scripts()) {
    if (!use.has(script)) continue;
    constexpr const char* kinds[] = {"event", "rover", "terrain", "soil", "lib"};
    values[fmt::format("{}_{}_sha256", kinds[static_cast<int>(script.kind)], script.name)] =
        script.sha256;
  }
  return values;
}

}  // namespace lsos
