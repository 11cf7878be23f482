// What a planner must hear of an estimate: events that are expected to fail, to be cut off or
// never to start, and how many others do not take place then.
#pragma once

#include <vector>

#include "base/error.h"
#include "mission/estimate/event_estimate.h"
#include "plan/plan.h"

namespace lsos {

// `known`: faults found otherwise; an event that one of them names at its place is left out.
std::vector<Fault> estimate_warnings(const std::vector<EventEstimate>& events, const Plan& plan,
                                     const std::vector<Fault>& known);

}  // namespace lsos
