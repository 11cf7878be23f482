// The mission as a table of time for a terminal: days, in each a line a rover with its events.
#pragma once

#include <map>
#include <string>

#include "mission/mission_estimate.h"
#include "plan/declaration.h"

namespace lsos {

inline constexpr const char* timeline_legend =
    "D drive, E EVA, S science, C charge, A antenna, W wait, O other; below n no Sun on its "
    "panels, "
    "s they are stowed, e no Earth, b that and n or s";

// Days of 24 h from the mission's start, a letter each 20 min: that of the event that takes most of
// it, D of driving, E of EVAs, S of science, C of charging and loads, A of antennas, W of waiting,
// O of others; '.' where none does. A drive that takes most of no letter's time stands where most
// of it is. Below, where anything is dark or unseen, a line with n (no Sun on panels that are up),
// s (panels stowed), e (no Earth) or b (no Earth, and n or s).
std::string timeline_text(const MissionEstimate& estimate,
                          const std::map<std::string, Activity>& activities, Instant start);

}  // namespace lsos
