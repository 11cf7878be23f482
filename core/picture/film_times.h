// Times of a run that a film shows: drives slowly, quiet hours fast.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "record/log.h"

namespace lsos {

struct FilmTime {
  SimTime time{};
  double rate = 1;  // mission time per time of the film
  bool is_quiet = false;
};

// Intervals in which a rover drives, with a margin before and after.
using DriveTimes = std::vector<std::pair<SimTime, SimTime>>;
// Drives of `rover`, "" for the first rover; ascending and disjoint. `interval`: LogInterval, the
// margin.
DriveTimes drive_times(const LogReader& log, const std::string& rover, SimTime interval);

// Some 250 times from 0 to `end`: four in five of them are spread evenly over the drives, the rest
// over the times between. Where there are only drives or none, all are spread evenly.
std::vector<FilmTime> film_times(const DriveTimes& drives, SimTime end);
// Times at the interval `every`, "10 s" or "2 min". Throws InputError.
std::vector<FilmTime> film_times(const std::string& every, SimTime end);

}  // namespace lsos
