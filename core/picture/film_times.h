// The moments of a run that a film shows: its drive slowly, its quiet hours fast.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "record/log.h"

namespace lsos {

struct FilmTime {
  SimTime time{};
  double rate = 1;  // times as fast as the mission
  bool is_quiet = false;
};

// While a rover drives, and shortly before and after.
using DriveTimes = std::vector<std::pair<SimTime, SimTime>>;
// Of that rover, "" for the first; ascending and apart. `interval`: LogInterval.
DriveTimes drive_times(const LogReader& log, const std::string& rover, SimTime interval);

// Some 250 moments from 0 to `end`: four in five of them, evenly, while the rover drives, the rest
// while it stands. Evenly over all where it does but one of the two.
std::vector<FilmTime> film_times(const DriveTimes& drives, SimTime end);
// One every so often, "10 s" or "2 min". Throws InputError.
std::vector<FilmTime> film_times(const std::string& every, SimTime end);

}  // namespace lsos
