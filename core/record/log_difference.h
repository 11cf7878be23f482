// Where two logs first differ, row by row and value by value.
#pragma once

#include <optional>
#include <string>

#include "record/columns.h"
#include "record/log.h"

namespace lsos {

struct LogDifference {
  std::string layer;
  std::int64_t row = 0;  // from 1
  std::string column;    // "" where one log has no such row; "geometry"
  ColumnValue a, b;
  // Of the row, as far as it has them: time_s, rover_id, sequence, from_id, ...
  std::string where;
};

// In the order of the digest; absent: the logs are equal.
std::optional<LogDifference> first_difference(const LogReader& a, const LogReader& b);

}  // namespace lsos
