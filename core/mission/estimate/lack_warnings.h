// What a planner must hear of the stretches in which rovers lack sunlight or contact, or in which
// WarnWhen is expected to hold.
#pragma once

#include <vector>

#include "base/error.h"
#include "mission/estimate/event_estimate.h"
#include "mission/estimate/lack.h"
#include "plan/plan.h"

namespace lsos {

// A warning a stretch, at the event in which it begins. Stretches of one kind that a rover has
// again and again, as nights, are told with the first.
std::vector<Fault> lack_warnings(const std::vector<Lack>& lacks, const Plan& plan);

// A warning an event whose WarnWhen asks whether Earth is seen, which is not sure for a part of its
// time, and of which `lacks` tell nothing.
std::vector<Fault> doubt_warnings(const std::vector<EventEstimate>& events,
                                  const std::vector<Lack>& lacks, const Plan& plan);

}  // namespace lsos
