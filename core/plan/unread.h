// Placemarks that are meant to be ours but whose type cannot be read. Other Placemarks may still
// refer to their ids.
#pragma once

#include <string>
#include <vector>

#include "plan/event_reader.h"

namespace lsos {

struct Unread {
  bool has_mission = false, has_rover = false;
  std::vector<std::string> rover_ids;
  std::vector<DraftEvent> events;  // with is_read = false
};

// Guesses the kind of each Placemark from its fields. The id of a rover or an asset, or the fact
// that it has none, is entered into `gaps`.
Unread read_unread(const std::vector<PlanPlacemark>& unread, const ReadContext& context,
                   PlanGaps& gaps);

}  // namespace lsos
