#include "plan/expected_places.h"

#include <map>
#include <string>

namespace lsos {

void visit_expected_places(
    const std::vector<DraftEvent>& drafts, const std::vector<PlanRover>& rovers,
    const PlanGaps& gaps,
    const std::function<void(const DraftEvent& draft, const std::optional<Geodetic>& expected)>&
        visit) {
  std::map<std::string, Geodetic> expected;  // by rover; of those for which it is known
  for (const PlanRover& rover : rovers) {
    if (!gaps.unplaced_rovers.contains(rover.id)) expected.emplace(rover.id, rover.start);
  }
  for (const DraftEvent& draft : drafts) {
    if (draft.is_placed || (draft.is_read && !draft.drives)) continue;
    if (!draft.is_rover_known) return;
    expected.erase(draft.event.rover_id);
  }
  for (const DraftEvent& draft : drafts) {
    const PlanEvent& event = draft.event;
    if (draft.drives && !draft.is_drive_known) expected.erase(event.rover_id);
    if (!draft.is_placed || !event.is_enabled || event.geometry.points.empty()) continue;
    const auto found = expected.find(event.rover_id);
    visit(draft, found == expected.end() ? std::nullopt : std::optional(found->second));
    if (found != expected.end() && draft.drives) found->second = event.geometry.points.back();
  }
}

}  // namespace lsos
