// The first difference between two logs, row by row and value by value.
#pragma once

#include <optional>
#include <string>

#include "record/columns.h"
#include "record/log.h"

namespace lsos {

struct LogDifference {
  std::string layer;
  std::int64_t row = 0;  // from 1
  std::string column;    // "geometry" for that; "" where one log lacks the row
  ColumnValue a, b;
  // Values that identify the row, as far as it has them: time_s, rover_id, sequence, from_id, ...
  std::string where;
};

// Compares in the order of the digest; absent: the logs are equal.
std::optional<LogDifference> first_difference(const LogReader& a, const LogReader& b);

}  // namespace lsos
