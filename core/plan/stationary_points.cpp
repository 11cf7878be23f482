// Points of events that do not drive, against where the rover is then expected.
#include <fmt/format.h>

#include <map>

#include "plan/references.h"
#include "plan/suggestions.h"

namespace lsos {

void check_stationary_points(const std::vector<DraftEvent>& drafts,
                             const std::vector<PlanRover>& rovers, const PlanGaps& gaps,
                             const Body& body, Faults& faults) {
  constexpr double tolerance_m = 50;
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
    if (found == expected.end()) continue;
    Geodetic& place = found->second;
    if (draft.drives) {
      place = event.geometry.points.back();
      continue;
    }
    const double distance_m = surface_distance_m(body, place, event.geometry.points.front());
    if (distance_m <= tolerance_m) continue;
    faults.warning({event.place.file, event.geometry.line},
                   fmt::format("{}: its Point is {:.0f} m from where rover {} then is expected; "
                               "{} does not drive there",
                               draft.subject, distance_m, quoted(event.rover_id), event.type));
  }
}

}  // namespace lsos
