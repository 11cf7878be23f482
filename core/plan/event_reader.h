// Reads the Placemarks that are events, each by itself. References between events (StartAfter,
// goto) are resolved afterwards, in references.h.
#pragma once

#include <string>
#include <vector>

#include "plan/draft_event.h"
#include "plan/mission_reader.h"

namespace lsos {

// The events by rover id, then sequence, then line. `rover_ids`: what RoverId may name, besides
// those that may name; no other id is a fault while `gaps` leave a rover's id open.
std::vector<DraftEvent> read_events(const std::vector<PlanPlacemark>& events,
                                    const ReadContext& context,
                                    const std::vector<std::string>& rover_ids,
                                    const PlanGaps& gaps);

// Which of the common event fields were filled in from their defaults, and in how many events:
// "Enabled = true (12 of 14 events)". `drafts`: the events, once apply_failure_defaults() has seen
// them.
std::vector<std::string> common_defaults(const std::vector<PlanPlacemark>& events,
                                         const std::vector<DraftEvent>& drafts);

}  // namespace lsos
