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

constexpr int film_pictures = 250, film_pictures_max = 20000;

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

std::vector<SimTime> film_times(const std::string& every, SimTime end) {
  SimTime step = std::max(exchange_period, round_up_to_exchange(end / film_pictures));
  if (!every.empty()) {
    const Parsed<double> step_s = parse_quantity(every, *find_unit("s"));
    if (!step_s) {
      throw InputError({},
                       fmt::format("--every {}: the mission's time from one picture to the next "
                                   "is wanted, as 10 s or 2 min",
                                   every));
    }
    const double least_s = std::max(seconds(exchange_period), seconds(end) / film_pictures_max);
    if (!(*step_s.value >= least_s)) {
      throw InputError(
          {}, fmt::format("--every {}: must be at least {:.3g} s in this run", every, least_s));
    }
    step = from_seconds(*step_s.value);
  }
  std::vector<SimTime> times;
  for (SimTime time{}; time <= end; time += step) times.push_back(time);
  return times;
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
  PictureRun run{
      mission_of_run(folder, log.run()), {}, log.start(), log.last_sample_time(), {}, {}, {}, {}};
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

PictureRun open_run(const std::string& folder, const std::string& at, const std::string& every) {
  const LogReader log(folder + "/log.gpkg");
  require_samples(log, folder);
  PictureRun run = open_run(folder, log);
  if (at.empty()) {
    read_moments(run, log, film_times(every, run.end));
    return run;
  }
  const SimTime time = time_since_start("--at", at, run.start);
  if (time < SimTime{} || time > run.end) {
    throw InputError({}, fmt::format("--at {}: the run is from {} to {}", at, format_utc(run.start),
                                     format_utc(run.start + run.end)));
  }
  read_moments(run, log, {time});
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
  const SampleRow& sample = moment.rover->sample;
  const SiteFrame& site = run.ground->site();
  // A parked rover has few samples; the Sun goes on.
  moment.utc = run.start + std::max(sample.time, run.times[k]);
  moment.sun = sunlight(site.body(), sample.place, moment.utc, 0);
  moment.sun_S = direction_S(site, sample.p_S_m, moment.sun.seen);
  return moment;
}

}  // namespace lsos
