// Where each rover is expected to be before each of its events.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "plan/draft_event.h"

namespace lsos {

// Where a rover is expected: at the last point it was to drive to, at its start, or anywhere within
// the polygon of its last drive; `at` is then one corner of the polygon.
struct ExpectedPlace {
  Geodetic at;
  std::vector<Geodetic> within;  // outline of the polygon; empty: exactly at `at`
};

// Calls `visit` for each enabled event with a geometry, in order of rover and sequence, with the
// place where its rover is expected before the event. The place is absent where it is not known:
// after a drive without a geometry, which follows something that moves, and where faults of the
// plan leave it open.
void visit_expected_places(
    const std::vector<DraftEvent>& drafts, const std::vector<PlanRover>& rovers,
    const PlanGaps& gaps,
    const std::function<void(const DraftEvent& draft,
                             const std::optional<ExpectedPlace>& expected)>& visit);

}  // namespace lsos
