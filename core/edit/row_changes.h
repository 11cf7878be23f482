// What rows of a sheet change in a plan that was drawn.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "edit/plan_thing.h"
#include "plan/declaration.h"
#include "plan/kml_source.h"

namespace lsos {

// What a sheet says of each of its rows, also where a cell is empty.
struct SheetColumns {
  std::set<std::string> names;  // of fields, "name", "description"
  bool has_places = false;
};

struct RowChange {
  ThingKey key;
  SourcePlacemark before;                // as the plan has it; of a row that is new: nothing
  SourcePlacemark after;                 // whole, with what the sheet has no column for
  std::vector<std::string> fields = {};  // names of those that change, in their order
  bool has_new_type = false, has_new_name = false, has_new_description = false,
       has_new_place = false;
};

struct RowChanges {
  std::vector<RowChange> changed, added;
  std::vector<ThingKey> without_row;  // things of the plan, in its order
  std::size_t unchanged = 0;
  KmlSource merged;  // the plan as it becomes, with things without a row
};

// `things`: of the plan, and `rows` of sheets, each with one SchemaData. `columns`: by the `file`
// of the rows. A row and a Placemark are one thing by their keys. An empty cell takes a value away;
// what a sheet has no column for stays. Rows without a key are added, for the plan's reader to
// refuse.
RowChanges row_changes(const KmlSource& things, const std::vector<SourcePlacemark>& rows,
                       const std::map<std::string, SheetColumns>& columns,
                       const Declarations& declarations);

// Those of `without_row` that may be removed for having none: of a kind of which the sheet has
// rows, or of `kinds`, and not the mission.
std::vector<ThingKey> removable(const RowChanges& changes, const std::vector<SourcePlacemark>& rows,
                                std::set<ThingKey::Kind> kinds = {});
// Takes them out of `without_row` and `merged`.
void leave_out(RowChanges& changes, const std::vector<ThingKey>& keys);

}  // namespace lsos
