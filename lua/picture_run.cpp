#include "lua/picture_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "lua/run_mission.h"
#include "mission/site.h"
#include "product/files.h"

namespace lsos {

namespace {

// Of the scripts and the ground that the run names, those that are not what they were.
std::vector<std::string> changed_since(const MissionFiles& files, const Ground& ground,
                                       const std::map<std::string, std::string>& run) {
  std::vector<std::string> changed;
  for (const Script& script : files.catalog->scripts()) {
    if (script.kind != ScriptKind::rover) continue;
    const auto hash = run.find(fmt::format("rover_{}_sha256", script.name));
    if (hash == run.end() || hash->second == script.sha256) continue;
    changed.push_back(script.file);
  }
  const auto hash = run.find("terrain_sha256");
  if (hash != run.end() && hash->second != ground.hash()) changed.push_back("the terrain");
  return changed;
}

}  // namespace

SimTime time_since_start(const std::string& option, const std::string& text, Instant start) {
  if (const Parsed<double> time_s = parse_quantity(text, *find_unit("s")))
    return from_seconds(*time_s.value);
  if (const Parsed<Instant> at = parse_utc(text)) return *at.value - start;
  throw InputError({}, fmt::format("{} {}: UTC or a time from the start is wanted, as "
                                   "2026-07-01T00:10:00Z or 10 min",
                                   option, text));
}

PictureRun open_run(const std::string& folder, const LogReader& log) {
  PictureRun run{mission_of_run(folder, log.run()),
                 {},
                 log.start(),
                 log.last_sample_time(),
                 {},
                 {},
                 {},
                 {},
                 {}};
  run.files.faults.throw_if_errors();
  const MissionInfo& mission = run.files.plan.mission;
  run.ground = ground_at(run.files.terrain, *mission.planet, run.files.plan.rovers.front().start,
                         mission.seed);
  for (const std::string& what : changed_since(run.files, *run.ground, log.run())) {
    run.warnings.push_back(
        fmt::format("{} is not what it was when {} was run: the picture may differ", what, folder));
  }
  return run;
}

void read_moments(PictureRun& run, const LogReader& log, const std::vector<SimTime>& times) {
  run.times = times;
  run.logged = read_logged(log, run.times, *run.ground, run.files.plan.mission.log_interval);
  run.rovers.clear();
  for (const auto& [id, track] : run.logged.tracks) run.rovers.push_back(id);
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

PictureMoment moment(const PictureRun& run, std::size_t k, const std::string& rover) {
  PictureMoment moment;
  moment.rovers = &run.logged.moments[k];
  std::vector<std::string> ids;
  for (const LoggedRover& logged : *moment.rovers) {
    ids.push_back(logged.sample.rover_id);
    if (!moment.rover && (rover.empty() || ids.back() == rover)) moment.rover = &logged;
  }
  if (!moment.rover) {
    throw InputError({}, rover.empty() ? "the run has no sample until then"
                                       : fmt::format("--rover {}: the run has no such rover{}",
                                                     rover, did_you_mean(rover, ids)));
  }
  if (!run.film.empty()) moment.film = run.film[k];
  const SampleRow& sample = moment.rover->sample;
  const SiteFrame& site = run.ground->site();
  // A parked rover has few samples; the Sun goes on.
  moment.utc = run.start + std::max(sample.time, run.times[k]);
  moment.sun = sunlight(site.body(), sample.place, moment.utc, 0);
  moment.sun_S = direction_S(site, sample.p_S_m, moment.sun.seen);
  return moment;
}

}  // namespace lsos
