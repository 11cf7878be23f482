// How rovers are expected to begin a day, for `edit split`.
#pragma once

#include <map>
#include <string>

#include "edit/split.h"
#include "lua/host/mission_files.h"

namespace lsos {

// Estimates the mission up to that day, counted from 1, and beyond it until the events of earlier
// days have ended. `days`: which day each event belongs to. A rover whose earlier events do not end
// is left out. Throws InputError where the mission cannot be estimated.
std::map<std::string, DayBegin> day_begins(const MissionFiles& files, int day,
                                           const EventDays& days);

}  // namespace lsos
