// Compares the Points of events that do not drive with the places where the rover is then expected.
#include <fmt/format.h>

#include "plan/expected_places.h"
#include "plan/far_places.h"
#include "plan/polygon_rings.h"
#include "plan/references.h"
#include "plan/suggestions.h"

namespace lsos {

void check_stationary_points(const std::vector<DraftEvent>& drafts,
                             const std::vector<PlanRover>& rovers, const PlanGaps& gaps,
                             const Body& body, Faults& faults) {
  constexpr double tolerance_m = 50;
  visit_expected_places(
      drafts, rovers, gaps,
      [&](const DraftEvent& draft, const std::optional<ExpectedPlace>& expected) {
        if (draft.drives || draft.event.at || !expected) return;
        const PlanEvent& event = draft.event;
        const Geodetic& point = event.geometry.points.front();
        const double distance_m = expected->within.empty()
                                      ? surface_distance_m(body, expected->at, point)
                                      : outside_m(body, expected->within, point);
        if (distance_m <= tolerance_m) return;
        faults.warning(
            {event.place.file, event.geometry.line},
            fmt::format("{}: its Point is {} from where rover {} then is expected; {} does not "
                        "drive there{}",
                        draft.subject, distance_text(distance_m), quoted(event.rover_id),
                        event.type, exchanged_text(body, expected->at, point)));
      });
}

}  // namespace lsos
