// Default MaxDuration, for plans that give none.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "mission/model/rover_model.h"
#include "plan/plan.h"

namespace lsos {

// Longest default, 366 d.
inline constexpr SimTime longest_mission{366LL * 86'400 * 1'000'000};

// 366 d when an event can start or end only by a condition: it has a StartWhen or StopWhen, or
// `is_open_ended` is true for it. Else the sum, in whole hours, of what the plan allows for: the
// latest time in it, all durations, three times the drawn lengths at the requested speeds, and a
// day.
SimTime default_max_duration(const Plan& plan, const Declarations& declarations,
                             const std::map<std::string, RoverModel>& rovers,
                             const std::function<bool(const PlanEvent&)>& is_open_ended);

}  // namespace lsos
