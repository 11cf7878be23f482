#include "picture/picture_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/quantity.h"

namespace lsos {

SimTime time_since_start(const std::string& option, const std::string& text, Instant start) {
  if (const Parsed<double> time_s = parse_quantity(text, *find_unit("s")))
    return from_seconds(*time_s.value);
  if (const Parsed<Instant> at = parse_utc(text)) return *at.value - start;
  throw InputError({}, fmt::format("{} {}: UTC or a time from the start is wanted, as "
                                   "2026-07-01T00:10:00Z or 10 min",
                                   option, text));
}

void read_moments(PictureRun& run, const LogReader& log, const std::vector<SimTime>& times) {
  run.times = times;
  run.logged = read_logged(log, run.times, *run.ground, run.files.plan.mission.log_interval);
  run.rovers.clear();
  for (const auto& [id, track] : run.logged.tracks) run.rovers.push_back(id);
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
