// What a plan asks for in vain, as far as that is known before it runs: times that are over or
// never come, powers that nothing gives, levels of what is not there.
#pragma once

#include <map>
#include <string>

#include "mission/rover_model.h"
#include "plan/plan.h"

namespace lsos {

// Adds warnings.
void check_plan_aims(const Plan& plan, const Declarations& declarations,
                     const std::map<std::string, RoverModel>& rovers,
                     const std::map<std::string, AssetModel>& assets, Faults& faults);

}  // namespace lsos
