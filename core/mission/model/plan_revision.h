// Whether a plan can take the place of another while its mission runs.
#pragma once

#include <map>
#include <set>
#include <string>

#include "plan/plan.h"

namespace lsos {

using EventReferences = std::set<PlanEvent::Reference>;

// Reports what of a mission that has begun `revised` would change: planet, start, ground, seed,
// rovers, assets, events that have begun or ended, and events that would come before those.
void check_revision(const Plan& plan, const EventReferences& begun, const Plan& revised,
                    Faults& faults);

// Which number in `revised` has each event that has begun and has another number there: the one
// event of its rover that has its label, when no event of the rover has its number.
std::map<PlanEvent::Reference, std::int64_t> renumbered_events(const Plan& plan,
                                                               const EventReferences& begun,
                                                               const Plan& revised);

}  // namespace lsos
