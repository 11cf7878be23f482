#include "plan/open_drives.h"

#include <algorithm>
#include <limits>
#include <set>

namespace lsos {

void find_open_drives(const std::vector<DraftEvent>& drafts, PlanGaps& gaps) {
  for (const DraftEvent& draft : drafts) {
    const PlanEvent& event = draft.event;
    if (draft.is_read && !draft.drives) continue;
    if (draft.is_read && draft.is_placed && draft.is_drive_known && event.has_all_params) continue;
    if (!draft.is_rover_known) {
      gaps.drives_of_any = true;
      continue;
    }
    const std::int64_t from =
        draft.is_sequence_known ? event.sequence : std::numeric_limits<std::int64_t>::min();
    const auto [entry, is_new] = gaps.open_drives.emplace(event.rover_id, from);
    if (!is_new) entry->second = std::min(entry->second, from);
  }
}

Plan with_known_drives(Plan plan) {
  std::set<PlanEvent::Reference> taken;
  std::erase_if(plan.events, [&](const PlanEvent& event) {
    const auto open = plan.gaps.open_drives.find(event.rover_id);
    const bool is_open = open != plan.gaps.open_drives.end() && event.sequence >= open->second;
    return is_open || !event.has_all_params || rover_of(plan, event.rover_id) == nullptr ||
           !taken.insert({event.rover_id, event.sequence}).second;
  });
  for (PlanEvent& event : plan.events) {
    event.start_after.clear();
    event.start_when = event.skip_when = event.stop_when = event.warn_when = {};
    event.on_failure = OnFailure::stop;
  }
  return plan;
}

}  // namespace lsos
