// Requests of a plan that cannot be met, as far as that is known before it runs: times that are
// over or never come, power that nothing gives, charge without a battery.
#pragma once

#include <map>
#include <string>

#include "mission/model/rover_model.h"
#include "plan/plan.h"

namespace lsos {

// Adds warnings.
void check_plan_requests(const Plan& plan, const Declarations& declarations,
                         const std::map<std::string, RoverModel>& rovers,
                         const std::map<std::string, AssetModel>& assets, Faults& faults);

// Adds warnings about rovers whose events take longer than the mission may, once its MaxDuration is
// known.
void check_plan_spans(const Plan& plan, const Declarations& declarations,
                      const std::map<std::string, RoverModel>& rovers, Faults& faults);

// Adds a warning when nothing is to happen, for a plan without errors.
void check_for_events(const Plan& plan, Faults& faults);

}  // namespace lsos
