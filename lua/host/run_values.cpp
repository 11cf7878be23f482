#include "lua/host/run_values.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/quantity.h"
#include "lua/host/script_use.h"
#include "lua/host/version.h"

namespace lsos {

namespace {

constexpr const char *site_lon_key = "from_site_lon_rad", *site_lat_key = "from_site_lat_rad";

}  // namespace

void restore_site(const std::map<std::string, std::string>& run, Plan& plan) {
  const auto lon = run.find(site_lon_key), lat = run.find(site_lat_key);
  if (lon == run.end() || lat == run.end()) return;
  const Unit& one = *find_unit("1");
  const Parsed<double> lon_rad = parse_quantity(lon->second, one);
  const Parsed<double> lat_rad = parse_quantity(lat->second, one);
  const bool is_place = lon_rad && lat_rad && std::abs(*lon_rad.value) <= std::numbers::pi &&
                        std::abs(*lat_rad.value) <= std::numbers::pi / 2;
  if (!is_place) {
    throw InputError({}, fmt::format("layer 'run' of the log: {} and {} are no place", site_lon_key,
                                     site_lat_key));
  }
  plan.mission.earlier_site = Geodetic{*lon_rad.value, *lat_rad.value, 0};
}

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
  if (files.from) {
    values[from_key] = files.from->log_sha256;
    values[site_lon_key] = fmt::format("{}", files.from->site.lon_rad);
    values[site_lat_key] = fmt::format("{}", files.from->site.lat_rad);
  }
  values.merge(script_digests(files));
  return values;
}

std::map<std::string, std::string> script_digests(const MissionFiles& files) {
  std::map<std::string, std::string> digests;
  const ScriptUse use(*files.catalog, files.plan, files.terrain);
  for (const Script& script : files.catalog->scripts()) {
    if (!use.has(script)) continue;
    constexpr const char* kinds[] = {"event", "rover", "terrain", "soil", "lib"};
    digests[fmt::format("{}_{}_sha256", kinds[static_cast<int>(script.kind)], script.name)] =
        script.sha256;
  }
  return digests;
}

}  // namespace lsos
