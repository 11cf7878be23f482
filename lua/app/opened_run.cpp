#include "lua/app/opened_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "lua/host/run_mission.h"
#include "mission/model/site.h"

namespace lsos {

namespace {

// Rover scripts, what they may share, and ground of the run that differ from those of today.
std::vector<std::string> changed_since(const MissionFiles& files, const Ground& ground,
                                       const std::map<std::string, std::string>& run) {
  std::vector<std::string> changed;
  for (const Script& script : files.catalog->scripts()) {
    const bool is_shared = script.kind == ScriptKind::shared;
    if (script.kind != ScriptKind::rover && !is_shared) continue;
    const auto hash =
        run.find(fmt::format("{}_{}_sha256", is_shared ? "lib" : "rover", script.name));
    if (hash == run.end() || hash->second == script.sha256) continue;
    changed.push_back(script.file);
  }
  const auto hash = run.find("terrain_sha256");
  if (hash != run.end() && hash->second != ground.hash()) changed.push_back("the terrain");
  return changed;
}

}  // namespace

PictureRun open_run(const std::string& folder, const LogReader& log) {
  const MissionFiles files = mission_of_run(folder, log.run());
  files.faults.throw_if_errors();
  PictureRun run;
  run.files = files;
  run.start = log.start();
  run.end = log.last_sample_time();
  const MissionInfo& mission = run.files.plan.mission;
  run.ground = ground_at(run.files.terrain, *mission.planet, site_of(run.files.plan), mission.seed);
  for (const std::string& what : changed_since(files, *run.ground, log.run())) {
    run.warnings.push_back(
        fmt::format("{} is not what it was when {} was run: the picture may differ", what, folder));
  }
  return run;
}

PictureRun open_picture(const std::string& folder, const std::string& at) {
  const LogReader log(folder + "/log.gpkg");
  require_samples(log, folder);
  PictureRun run = open_run(folder, log);
  const SimTime time = time_since_start("--at", at, run.start);
  if (time < SimTime{} || time > run.end) {
    throw InputError({}, fmt::format("--at {}: the run is from {} to {}", at, format_utc(run.start),
                                     format_utc(run.start + run.end)));
  }
  read_moments(run, log, {time});
  return run;
}

PictureRun open_film(const std::string& folder, const std::string& every,
                     const std::string& rover) {
  const LogReader log(folder + "/log.gpkg");
  PictureRun run = open_run(folder, log);
  const SimTime interval = run.files.plan.mission.log_interval;
  run.film = every.empty() ? film_times(drive_times(log, rover, interval), run.end)
                           : film_times(every, run.end);
  std::vector<SimTime> times;
  for (const FilmTime& film : run.film) times.push_back(film.time);
  read_moments(run, log, times);
  return run;
}

LoggedMission open_without_ground(const std::string& folder, const LogReader& log) {
  LoggedMission opened;
  MissionFiles files = mission_of_run(folder, log.run());
  if (files.plan.mission.planet == nullptr) files.faults.throw_if_errors();
  opened.run.files = std::move(files);
  opened.run.start = log.start();
  opened.run.end = log.last_sample_time();
  return opened;
}

LoggedMission open_run_or_log(const std::string& folder, const LogReader& log) {
  LoggedMission opened;
  try {
    opened.run = open_run(folder, log);
    for (const std::string& warning : opened.run.warnings) opened.left_out.push_back(warning);
    return opened;
  } catch (const InputError& error) {
    const std::string why = fmt::format("map and pictures: {}", error.what());
    opened = open_without_ground(folder, log);
    opened.left_out.push_back(why);
    return opened;
  }
}

}  // namespace lsos
