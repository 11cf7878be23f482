// What events say of each other: StartAfter and OnFailure = goto LABEL.
#pragma once

#include <vector>

#include "plan/event_reader.h"

namespace lsos {

// Resolves them all into `drafts`, which are in order of rover and sequence. An unknown or
// ambiguous reference, and a goto to an event that is not later on the same rover, is a fault,
// unless it may be to one whose rover or Sequence cannot be read.
void resolve_references(std::vector<DraftEvent>& drafts, Faults& faults);

// Faults for events that wait for each other in a circle and would never start. An event waits
// for what its StartAfter names and for the events before it on its own rover.
void check_circles(const std::vector<DraftEvent>& drafts, Faults& faults);

// Warnings for stationary events whose Point is not where the rover is then expected, as far as
// faults leave that known.
void check_stationary_points(const std::vector<DraftEvent>& drafts,
                             const std::vector<PlanRover>& rovers, const PlanGaps& gaps,
                             const Body& body, Faults& faults);

// "a, b\, c" -> "a", "b, c"; without the blanks around each.
std::vector<std::string> split_references(const std::string& text);

}  // namespace lsos
