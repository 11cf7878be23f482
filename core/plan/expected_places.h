// Where each rover is expected to be as its events come.
#pragma once

#include <functional>
#include <optional>

#include "plan/event_reader.h"

namespace lsos {

// Calls `visit` for each enabled event with a geometry, in order of rover and sequence, with the
// place where its rover is expected to be before it: at the last point that it was to drive to, or
// at its start. Nothing where faults of the plan leave that open.
void visit_expected_places(
    const std::vector<DraftEvent>& drafts, const std::vector<PlanRover>& rovers,
    const PlanGaps& gaps,
    const std::function<void(const DraftEvent& draft, const std::optional<Geodetic>& expected)>&
        visit);

}  // namespace lsos
