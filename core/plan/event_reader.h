// Reads the Placemarks that are events, each by itself; what they say of each other (StartAfter,
// goto) is resolved afterwards, in references.h.
#pragma once

#include <string>
#include <vector>

#include "plan/draft_event.h"
#include "plan/mission_reader.h"

namespace lsos {

// By rover id, then sequence, then line. `rover_ids`: what RoverId may name, besides those that
// `gaps` leave open.
std::vector<DraftEvent> read_events(const std::vector<OurPlacemark>& events,
                                    const ReadContext& context,
                                    const std::vector<std::string>& rover_ids,
                                    const PlanGaps& gaps);

// "Enabled = true (12 of 14 events)": of the fields that all events have, which were filled in.
std::vector<std::string> common_defaults(const std::vector<OurPlacemark>& events);

}  // namespace lsos
