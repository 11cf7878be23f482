// Points of events that do not drive, against where the rover is then expected.
#include <fmt/format.h>

#include <map>

#include "plan/references.h"
#include "plan/suggestions.h"

namespace lsos {

void check_stationary_points(const std::vector<DraftEvent>& drafts,
                             const std::vector<PlanRover>& rovers, const Body& body,
                             Faults& faults) {
  constexpr double tolerance_m = 50;
  std::map<std::string, Geodetic> expected;  // by rover
  for (const PlanRover& rover : rovers) expected.emplace(rover.id, rover.start);
  for (const DraftEvent& draft : drafts) {
    const PlanEvent& event = draft.event;
    if (!draft.is_placed || !event.is_enabled || event.geometry.points.empty()) continue;
    Geodetic& place = expected.at(event.rover_id);
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
