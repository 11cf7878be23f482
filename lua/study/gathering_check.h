// Whether what a study gathers is in its plan and its log.
#pragma once

#include "lua/host/mission_files.h"
#include "study/study.h"

namespace lsos {

// Checks what is to be gathered; events become ROVER/SEQUENCE, and each gathering gets a name.
void check_gatherings(const MissionFiles& mission, Study& study, Faults& faults);

// Ids of the plan's rovers, in its order.
std::vector<std::string> rover_ids(const Plan& plan);

}  // namespace lsos
