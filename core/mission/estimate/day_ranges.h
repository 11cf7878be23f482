// How sure the sums of days are: by the ranges of the events on each.
#pragma once

#include <vector>

#include "mission/estimate/event_estimate.h"

namespace lsos {

// Sets the ranges of `days` from those of `events`. What an event may use or get less or more is
// spread evenly over its time; a charge is as sure as at the last end of an event before.
void add_day_ranges(std::vector<DayEstimate>& days, const std::vector<EventEstimate>& events);

}  // namespace lsos
