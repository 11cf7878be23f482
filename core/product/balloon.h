// What a map's balloons say of the rows of a log: tables in units that people read.
#pragma once

#include <string>

#include "planet/utc.h"
#include "record/rows.h"

namespace lsos {

// HTML. Values that are not modelled are left out.
std::string balloon(const SampleRow& row, Instant start);
std::string balloon(const EventRow& row, Instant start);
std::string balloon(const PlannedPathRow& row);

}  // namespace lsos
