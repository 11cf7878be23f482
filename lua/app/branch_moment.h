// When a branch leaves a run, and what of the run has begun by then.
#pragma once

#include <string>

#include "mission/model/plan_revision.h"
#include "record/log.h"

namespace lsos {

// `at`: UTC, a time from the mission's start, or an event by its label or as ROVER/SEQUENCE; a
// branch leaves at an exchange, for an event at the last one before it begins. Throws InputError.
SimTime branch_moment(const LogReader& log, const std::string& folder, const std::string& at);

// Events of the run that have begun or ended by then.
EventReferences begun_events(const LogReader& log, SimTime moment);

}  // namespace lsos
