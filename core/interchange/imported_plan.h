// Makes a plan of tables: which rows are its things, where they are, when they begin.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "interchange/table.h"
#include "plan/declaration.h"
#include "plan/kml_source.h"

namespace lsos {

struct ImportedPlan {
  // Placemarks with one SchemaData each, in folders by rover and day.
  KmlSource source;
  // Places that rows name, which are no part of the plan but keep their names on its map.
  std::vector<SourcePlacemark> places = {};
  // Places that no row names, and features that are nothing of a plan: "map.gpkg/Craters: 12
  // features without a Type: Crater A, ...". They are not in the plan.
  std::vector<std::string> left_out;
  // How texts were understood: "'sev a' is taken for 'SEV A'".
  std::vector<std::string> notes = {};
};

// A row is what its Type says, else what its sheet or layer is called after (`Route`, `Rovers`). A
// feature or row with a name and a place, but no Type, is a place for others to name. Empty cells
// of RoverId and Day are as in the row above. An event without a Sequence comes 10 after the
// rover's row before, or between it and the one after. Reports faults of cells; what a plan may not
// say is found when it is read.
//
// `rows`: a plan of their own, or changes of one that was drawn, whose other events they need not
// have: each event then must have its Sequence, and lines begin as they are written.
enum class ImportedRows { plan, changes };
ImportedPlan import_tables(std::vector<Table> tables, const Declarations& declarations,
                           Faults& faults, ImportedRows rows = ImportedRows::plan);

}  // namespace lsos
