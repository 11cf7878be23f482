// What is known before the run to go wrong in it.
#pragma once

#include <string>

#include "base/error.h"
#include "plan/plan.h"

namespace lsos {

// An event that can only fail: an error, or a warning where the plan says what shall happen then
// (OnFailure other than stop). `line`: of the plan; 0: the event's own.
Fault foreseen_failure(const PlanEvent& event, const std::string& what, int line = 0);

}  // namespace lsos
