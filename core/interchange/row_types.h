// What each row of a table is: a thing of a plan, a place for others to name, or nothing.
#pragma once

#include <set>
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

  // The row's text in a column, by its canonical name; "" when there is none.
  std::string text(const std::string& column) const { return columns->text(*row, column); }
  // Where that cell stands; the row where there is no such column.
  Place cell_place(const std::string& column) const;
};

struct TypedRows {
  std::vector<TypedRow> rows;
  bool are_none = false;  // all rows of the sheet are nothing, which is reported
};

// Names that the rows of sheets and outlines give to places, in small letters.
std::set<std::string> wanted_places(const Table& table, const Columns& columns);

// The rows of a table that are things of a plan. Others with a name and a place are added to
// `places`, also features of a layer that is called as an event where they are `wanted` and have no
// RoverId; features of a map that are nothing are counted in `left_out`, and rows of a sheet that
// are nothing are reported.
TypedRows typed_rows(const Table& table, const Columns& columns, const Declarations& declarations,
                     const std::set<std::string>& wanted, PlaceNames& places,
                     std::vector<std::string>& left_out, Faults& faults);

}  // namespace lsos
