// Conditions that mean something else in a copy, or when the mission starts later.
#pragma once

#include <string>

#include "plan/plan.h"

namespace lsos {

// Which quantities that count from the mission's start the event's conditions name, for messages:
// "time_s, distance_m"; "" for none.
std::string counted_quantities(const PlanEvent& event);

}  // namespace lsos
