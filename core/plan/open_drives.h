// Where faults of a plan leave open where its rovers drive.
#pragma once

#include <vector>

#include "plan/draft_event.h"

namespace lsos {

// Enters into `gaps` the drives that cannot be followed because of faults of their events. An event
// of a type that cannot be read may be a drive. Draft by draft, in any order.
void find_open_drives(const std::vector<DraftEvent>& drafts, PlanGaps& gaps);

// The plan without what faults leave open, for its routes: no event without all its values, its
// rover or a Sequence of its own, none from an open drive on, and no event waits for anything.
Plan with_known_drives(Plan plan);

}  // namespace lsos
