// A plan as tables, for spreadsheets and maps.
#pragma once

#include <string>
#include <vector>

#include "interchange/table.h"
#include "plan/declaration.h"
#include "plan/kml_source.h"

namespace lsos {

// The things of a plan, each with one SchemaData: the mission, rovers, assets, then events by rover
// and Sequence. Fields of other kinds and decoration are left out.
KmlSource plan_things(const KmlSource& source, const Declarations& declarations);

enum class TableDivision {
  none,     // all in one table, with a column Type
  parts,    // Mission, Rovers, Assets and Events
  by_type,  // a table for each NAME
};

// Tables of plan_things(), with columns in the order in which people read them. Texts stay as they
// are written. Places are in columns Lon and Lat, or WKT for lines and polygons; or, with
// `has_geometries`, the rows' geometries.
std::vector<Table> plan_tables(const KmlSource& things, const Declarations& declarations,
                               TableDivision division, bool has_geometries);

}  // namespace lsos
