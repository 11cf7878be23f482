#include "picture/film_times.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/quantity.h"
#include "picture/film.h"

namespace lsos {

namespace {

constexpr int film_pictures = 250, film_pictures_max = 20000;
constexpr int quiet_pictures = film_pictures / 5;

SimTime step_of(SimTime time, int pictures) {
  return std::max(exchange_period, round_up_to_exchange(time / pictures));
}

// Adds a last time, so that the film shows the run's end.
void add_end(std::vector<FilmTime>& times, SimTime end) {
  if (times.empty() || times.back().time >= end) return;
  times.push_back(times.back());
  times.back().time = end;
}

double rate_of(SimTime step) { return seconds(step) * film_frames_per_s; }

}  // namespace

DriveTimes drive_times(const LogReader& log, const std::string& rover, SimTime interval) {
  const std::map<std::string, SampleTotals> totals = log.sample_totals();
  if (totals.empty()) return {};
  const std::string id = rover.empty() ? totals.begin()->first : rover;
  DriveTimes drives;
  log.for_each_sample([&](const SampleRow& row) {
    if (row.rover_id != id || row.speed_mps <= moving_mps) return;
    const SimTime from = std::max(SimTime{}, row.time - interval), to = row.time + interval;
    if (!drives.empty() && from <= drives.back().second) {
      drives.back().second = to;
    } else {
      drives.emplace_back(from, to);
    }
  });
  return drives;
}

std::vector<FilmTime> film_times(const DriveTimes& drives, SimTime end) {
  SimTime driving{};
  for (const auto& [from, to] : drives) driving += std::min(to, end) - from;
  const SimTime quiet = end - driving;
  const bool has_both = driving > SimTime{} && quiet > SimTime{};
  const SimTime drive_step =
      has_both ? step_of(driving, film_pictures - quiet_pictures) : step_of(end, film_pictures);
  // Quiet time never passes more slowly than a drive.
  const SimTime quiet_step =
      has_both ? std::max(drive_step, step_of(quiet, quiet_pictures)) : drive_step;
  std::vector<FilmTime> times;
  auto drive = drives.begin();
  for (SimTime time{}; time <= end;) {
    while (drive != drives.end() && drive->second <= time) ++drive;
    const bool is_quiet = drive == drives.end() || time < drive->first;
    const SimTime step = is_quiet ? quiet_step : drive_step;
    times.push_back({time, rate_of(step), is_quiet});
    time += step;
    if (is_quiet && drive != drives.end()) time = std::min(time, drive->first);
  }
  add_end(times, end);
  return times;
}

std::vector<FilmTime> film_times(const std::string& every, SimTime end) {
  const Parsed<double> step_s = parse_quantity(every, *find_unit("s"));
  if (!step_s) {
    throw InputError({}, fmt::format("--every {}: the mission's time from one picture to the next "
                                     "is wanted, as 10 s or 2 min",
                                     every));
  }
  const double least_s = std::max(seconds(exchange_period), seconds(end) / film_pictures_max);
  if (!(*step_s.value >= least_s)) {
    throw InputError(
        {}, fmt::format("--every {}: must be at least {:.3g} s in this run", every, least_s));
  }
  const SimTime step = from_seconds(*step_s.value);
  std::vector<FilmTime> times;
  for (SimTime time{}; time <= end; time += step) times.push_back({time, rate_of(step), false});
  add_end(times, end);
  return times;
}

}  // namespace lsos
