// Other numbers for events of a plan, in its source.
#pragma once

#include <map>

#include "plan/kml_source.h"
#include "plan/plan.h"

namespace lsos {

// Gives events another Sequence, also where StartAfter names them by it. `numbers`: the number that
// an event has in `source`, by the one that it gets.
void renumber_events(KmlSource& source,
                     const std::map<PlanEvent::Reference, std::int64_t>& numbers);

}  // namespace lsos
