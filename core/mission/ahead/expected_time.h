// About when the events of a plan end, before it runs.
#pragma once

#include "mission/model/machine.h"
#include "planet/site_frame.h"

namespace lsos {

// By the durations and times that the plan gives and the length of what is drawn, at the Speed
// asked for, else at 1 m/s. Counted from the mission's start. `begins`: when its turn comes; `at`:
// where the rover then is; at the end where it then is.
SimTime expected_end(const EventMachine& machine, SimTime begins, Instant mission_start,
                     const SiteFrame& site, Geodetic& at);

}  // namespace lsos
