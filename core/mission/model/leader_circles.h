// Finds rovers that follow each other in a circle: none of them would ever set off or end.
#pragma once

#include "base/error.h"
#include "plan/declaration.h"
#include "plan/plan.h"

namespace lsos {

// Adds an error, at its first event, for each circle of enabled events whose fields name leaders
// (NameOf::leader); a rover that follows itself is the smallest.
void check_leader_circles(const Plan& plan, const Declarations& declarations, Faults& faults);

}  // namespace lsos
