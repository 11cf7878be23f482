// A plan as tables, for spreadsheets and maps.
#pragma once

#include <string>
#include <vector>

#include "interchange/place_book.h"
#include "interchange/table.h"
#include "plan/declaration.h"
#include "plan/kml_source.h"

namespace lsos {

// The things of a plan, each with one SchemaData: the mission, rovers, assets, then events by rover
// and Sequence. Fields of other kinds and decoration are left out.
KmlSource plan_things(const KmlSource& source, const Declarations& declarations);

enum class TableDivision {
  none,     // all in one table, with a column Type
  parts,    // Mission, Rovers, Assets, Places and Events
  by_type,  // a table for each NAME, whose rows have geometries
};

// Tables of plan_things(), with columns in the order in which people read them. For maps (by_type,
// or `has_geometries`) texts stay as they are written. Sheets are for people: days and clock times,
// places by name, with a row each, and units in the headers, where exactly the same value is read
// back; WKT for lines of many points and polygons.
std::vector<Table> plan_tables(const KmlSource& things, const Declarations& declarations,
                               TableDivision division, bool has_geometries,
                               const std::vector<Landmark>& landmarks = {});

}  // namespace lsos
