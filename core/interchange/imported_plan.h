// Makes a plan of tables: which rows are its things, where they are, when they begin.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "interchange/place_book.h"
#include "interchange/table.h"
#include "plan/declaration.h"
#include "plan/kml_source.h"

namespace lsos {

// A plan that was drawn, to which rows are changes.
struct DrawnPlan {
  KmlSource things;              // see plan_things()
  std::vector<Landmark> places;  // see landmarks(): places for rows, too
};

// A place of a drawn plan that a sheet has elsewhere.
struct MovedPlace {
  Landmark place;
  std::string coordinates;  // where it is to be
};

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
  // Indices of Placemarks that drive to several places by name: their lines begin where the rover
  // stands, see begin_lines_at_rovers(). Changes of a drawn plan do not begin so yet.
  std::vector<std::size_t> ways = {};
  std::vector<MovedPlace> moved_places = {};
};

// A row is what its Type says, else what its sheet or layer is called after (`Route`, `Rovers`). A
// feature or row with a name and a place, but no Type, is a place for others to name. Empty cells
// of RoverId and Day are as in the row above. An event without a Sequence comes 10 after the
// rover's row before, or between it and the one after. Reports faults of cells; what a plan may not
// say is found when it is read. Throws InputError with them where a sheet says of no row what it
// is.
//
// `drawn`: the plan that the rows change; nullptr: they are a plan of their own. The rows need not
// have its other events. Each event must have its Sequence, and where it is stays where the sheet
// does not say it.
ImportedPlan import_tables(std::vector<Table> tables, const Declarations& declarations,
                           Faults& faults, const DrawnPlan* drawn = nullptr);

}  // namespace lsos
