// What a plan asks for in vain, as far as that is known before it runs: times that are over or
// never come, powers that nothing gives, levels of what is not there.
#pragma once

#include <map>
#include <string>

#include "mission/model/rover_model.h"
#include "plan/plan.h"

namespace lsos {

// Adds warnings.
void check_plan_aims(const Plan& plan, const Declarations& declarations,
                     const std::map<std::string, RoverModel>& rovers,
                     const std::map<std::string, AssetModel>& assets, Faults& faults);

// The same of what takes longer than the mission may, once its MaxDuration is known.
void check_plan_spans(const Plan& plan, const Declarations& declarations,
                      const std::map<std::string, RoverModel>& rovers, Faults& faults);

// A warning where nothing is to happen, of a plan without errors.
void check_for_events(const Plan& plan, Faults& faults);

}  // namespace lsos
