// The text that `lsos-host new study` writes: a study of a plan to start from.
#pragma once

#include <string>

#include "mission/model/mission_model.h"

namespace lsos {

// A study of six cases over `plan_file`, relative to where the study lies. The mission must have a
// rover.
std::string new_study_text(const MissionModel& mission, const std::string& plan_file);

}  // namespace lsos
