// What is checked of a plan's events by their scripts: fields and conditions.
#pragma once

#include "lua/host/mission_files.h"

namespace lsos {

// What the scripts say of the fields of a plan's events, and faults in their conditions. `files`:
// of the plan, with its rovers.
void check_events(const Plan& plan, const MissionFiles& files, Faults& faults);

// What events name and take of what their rovers have, see check_plan_names().
void check_names(const Plan& plan, const MissionFiles& files, Faults& faults);

}  // namespace lsos
