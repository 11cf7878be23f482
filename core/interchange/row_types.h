// What each row of a table is: a thing of a plan, a place for others to name, or nothing.
#pragma once

#include <string>
#include <vector>

#include "interchange/columns.h"
#include "interchange/places.h"

namespace lsos {

struct TypedRow {
  const Table* table = nullptr;
  const TableRow* row = nullptr;
  const Columns* columns = nullptr;
  std::string type;  // MissionInfo, Rover, Asset or an event
};

// The rows of a table that are things of a plan. Others with a name and a place are added to
// `places`; features of a map that are nothing are counted in `left_out`, and rows of a sheet that
// are nothing are reported.
std::vector<TypedRow> typed_rows(const Table& table, const Columns& columns,
                                 const Declarations& declarations, PlaceNames& places,
                                 std::vector<std::string>& left_out, Faults& faults);

}  // namespace lsos
