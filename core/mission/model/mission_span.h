// How long a mission may take whose plan gives no MaxDuration.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "mission/model/rover_model.h"
#include "plan/plan.h"

namespace lsos {

// No default is longer than this.
inline constexpr SimTime longest_mission{366LL * 86'400 * 1'000'000};

// 366 d when an event can start or end only by a condition: it has a StartWhen or StopWhen, or
// `is_open_ended` says so. Else what the plan allows for, in whole hours: the latest time in it,
// all durations, three times the drawn lengths at the speeds asked for, and a day.
SimTime default_max_duration(const Plan& plan, const Declarations& declarations,
                             const std::map<std::string, RoverModel>& rovers,
                             const std::function<bool(const PlanEvent&)>& is_open_ended);

}  // namespace lsos
