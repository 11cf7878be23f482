// Failures that are certain before the run.
#pragma once

#include <string>

#include "base/error.h"
#include "plan/plan.h"

namespace lsos {

// Fault for an event that can only fail: an error, or a warning when the plan handles the failure
// (OnFailure other than stop). `line`: line of the plan; 0: that of the event.
Fault foreseen_failure(const PlanEvent& event, const std::string& what, int line = 0);

}  // namespace lsos
