// Where each rover is expected to be as its events come.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "plan/draft_event.h"

namespace lsos {

// Where a rover then is: at the last point that it was to drive to, at its start, or anywhere
// within the polygon of its last drive, with the place `at` one of its corners.
struct ExpectedPlace {
  Geodetic at;
  std::vector<Geodetic> within;  // outline; empty: at the place itself
};

// Calls `visit` for each enabled event with a geometry, in order of rover and sequence, with the
// place where its rover is expected to be before it. Nothing where that is not known: after a drive
// without a geometry, which follows what moves, and where faults of the plan leave it open.
void visit_expected_places(
    const std::vector<DraftEvent>& drafts, const std::vector<PlanRover>& rovers,
    const PlanGaps& gaps,
    const std::function<void(const DraftEvent& draft,
                             const std::optional<ExpectedPlace>& expected)>& visit);

}  // namespace lsos
