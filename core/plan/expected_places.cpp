#include "plan/expected_places.h"

#include <map>
#include <string>

namespace lsos {

namespace {

std::optional<ExpectedPlace> place_after(const PlanEvent& drive) {
  const std::vector<Geodetic>& points = drive.geometry.points;
  if (points.empty()) return {};
  const bool is_area = drive.geometry.kind == GeometryKind::polygon;
  return ExpectedPlace{points.back(), is_area ? points : std::vector<Geodetic>()};
}

}  // namespace

void visit_expected_places(
    const std::vector<DraftEvent>& drafts, const std::vector<PlanRover>& rovers,
    const PlanGaps& gaps,
    const std::function<void(const DraftEvent& draft,
                             const std::optional<ExpectedPlace>& expected)>& visit) {
  // Keyed by rover id; a rover whose place is left open by faults has no entry.
  std::map<std::string, std::optional<ExpectedPlace>> expected;
  for (const PlanRover& rover : rovers) {
    if (!gaps.unplaced_rovers.contains(rover.id))
      expected[rover.id] = ExpectedPlace{rover.start, {}};
  }
  for (const DraftEvent& draft : drafts) {
    if (draft.is_placed || (draft.is_read && !draft.drives)) continue;
    if (!draft.is_rover_known) return;
    expected.erase(draft.event.rover_id);
  }
  for (const DraftEvent& draft : drafts) {
    const PlanEvent& event = draft.event;
    if (draft.drives && !draft.is_drive_known) expected.erase(event.rover_id);
    if (!draft.is_placed || !event.is_enabled) continue;
    const auto found = expected.find(event.rover_id);
    const bool is_known = found != expected.end();
    const std::vector<Geodetic>& points = event.geometry.points;
    if (!points.empty()) visit(draft, is_known ? found->second : std::nullopt);
    if (is_known && draft.drives) found->second = place_after(event);
  }
}

}  // namespace lsos
