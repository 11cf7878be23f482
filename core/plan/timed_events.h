// Events that take effect at a time of their own, whatever their rover does (EventDeclaration::at).
#pragma once

#include <vector>

#include "plan/draft_event.h"

namespace lsos {

// Sets PlanEvent::at of the events whose plan gives that moment. While faults leave the mission's
// StartTime open, a UTC time counts as the start.
void set_times(std::vector<DraftEvent>& drafts, const Declarations& declarations,
               const MissionInfo& mission, const PlanGaps& gaps);

// Reports fields that suppose a turn, of events that need none. References must be resolved.
void check_timed_events(const std::vector<DraftEvent>& drafts, const Declarations& declarations,
                        Faults& faults);

}  // namespace lsos
