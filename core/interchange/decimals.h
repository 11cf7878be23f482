// Numbers of sheets in which a comma may be the decimal mark.
#pragma once

#include <string>

#include "base/parsed.h"
#include "interchange/columns.h"
#include "interchange/table.h"

namespace lsos {

// What the numbers of a sheet show of their decimal mark: "5,5" or "0,125" a comma, "5.5" a point;
// "1.200" and "1,200" show nothing.
enum class Decimals { points, commas, either };

// What the cells below fields of numbers show. Points where the table has no decimal commas.
Decimals decimals_of(const Table& table, const Columns& columns, const Declarations& declarations);

// The text with a decimal point and without separators of thousands: "1200.5 s" of "1.200,5 s".
// "1.200" is 1200 beside commas and 1.2 beside points; else refused, as is "1,200" beside points.
// Other texts stay as they are.
Parsed<std::string> with_decimal_point(const std::string& text, Decimals decimals);

}  // namespace lsos
