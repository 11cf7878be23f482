// References to events: StartAfter and OnFailure = goto LABEL, also of a Rover or the mission.
#pragma once

#include <vector>

#include "plan/event_reader.h"

namespace lsos {

// Resolves all references into `drafts`, which are in order of rover and sequence. An unknown or
// ambiguous reference, and a goto to an event that is not later on the same rover, is a fault,
// unless it may refer to an event whose rover or Sequence cannot be read.
void resolve_references(std::vector<DraftEvent>& drafts, Faults& faults);

// Gives events without an OnFailure that of their Rover, else that of the mission. goto LABEL there
// means the next later event of the same rover with that label; where there is none, the rover
// stops. A label that none of these rovers has is a fault. Returns lines for Plan::defaults.
std::vector<std::string> apply_failure_defaults(std::vector<DraftEvent>& drafts,
                                                const MissionInfo& mission,
                                                const std::vector<PlanRover>& rovers,
                                                Faults& faults);

// Reports events that wait for each other in a circle and would never start. An event waits for the
// events that its StartAfter names, for those before it on its own rover and, when it follows
// another rover until that one has ended, for the last event of that.
void check_circles(const std::vector<DraftEvent>& drafts, const Declarations& declarations,
                   Faults& faults);

// Warns of stationary events whose Point is not where the rover is then expected. Rovers whose
// place is left open by faults are not checked.
void check_stationary_points(const std::vector<DraftEvent>& drafts,
                             const std::vector<PlanRover>& rovers, const PlanGaps& gaps,
                             const Body& body, Faults& faults);

// Splits at commas that are not escaped and trims each part: "a, b\, c" -> "a", "b, c".
std::vector<std::string> split_references(const std::string& text);

}  // namespace lsos
