// Checks of rovers that follow others: the fields of events that name leaders (NameOf::leader).
#pragma once

#include <map>
#include <string>

#include "base/error.h"
#include "mission/model/rover_model.h"
#include "plan/declaration.h"
#include "plan/plan.h"

namespace lsos {

// Adds an error, at its first event, for each circle of rovers that follow each other: none of them
// would ever set off or end. A rover that follows itself is the smallest. Adds warnings about
// leaders that have no event, and distances that the two bodies do not allow. `rovers`: by
// PlanRover::model().
void check_followings(const Plan& plan, const Declarations& declarations,
                      const std::map<std::string, RoverModel>& rovers, Faults& faults);

}  // namespace lsos
