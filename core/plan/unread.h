// Placemarks that are meant to be ours but whose type cannot be read: what others may say of them.
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

// By the fields that each has. Ids that are missing go to `gaps`, and those that are there.
Unread read_unread(const std::vector<OurPlacemark>& unread, const ReadContext& context,
                   PlanGaps& gaps);

}  // namespace lsos
