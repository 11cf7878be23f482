// A mission that begins as another run ended.
#pragma once

#include <string>

#include "lua/host/mission_files.h"

namespace lsos {

inline constexpr const char* from_help =
    "A run's folder: rovers begin where and as it left them, by RoverId";

// Has the mission begin as the run in `folder` ended: sets `files.from` and the plan's site, from
// which simulation_setup() places the rovers. What does not fit is added to the faults: errors
// where the ground, a rover or the time is another, warnings of what a planner should know. The
// files must have no errors. Throws InputError when there is no such run.
void begin_from(const std::string& folder, MissionFiles& files);

// Throws InputError when the folder of the new run is that of the run with which it begins.
void check_not_from(const std::string& folder, const std::string& from);

}  // namespace lsos
