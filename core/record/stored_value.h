// Values and places as a log may hold them: what is written is held to the limits that a reader
// demands, so that a log never refuses its own rows. Only for use in this folder.
#pragma once

#include "record/columns.h"

namespace lsos {

// A text: bytes that are no UTF-8 become U+FFFD. A number that is outside the limits or not finite:
// it becomes NULL, and the answer is false.
bool hold_to(const ColumnLimits& limits, ColumnValue& value);

// Whether a number is within the limits; NaN is not.
bool is_within(const ColumnLimits& limits, double number);

// Whether it is finite and near the planet.
bool is_place(double lon_deg, double lat_deg, double height_m);

}  // namespace lsos
