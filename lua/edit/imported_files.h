// Files that are imported: sheets, maps, outlines as tables, and what is wrong with them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "edit/row_changes.h"
#include "interchange/table.h"
#include "plan/declaration.h"

namespace lsos {

// The tables of all files; `left_out`: see read_tables(). Throws InputError with the faults of all.
std::vector<Table> read_all_tables(const std::vector<std::string>& files,
                                   const Declarations& declarations,
                                   std::vector<std::string>& left_out);

// What the tables say of each of their rows, by the `file` of each.
std::map<std::string, SheetColumns> sheet_columns(const std::vector<Table>& tables,
                                                  const Declarations& declarations);

// What the sheets are of by their names or rows, also those with a header alone.
std::set<ThingKey::Kind> kinds_of_sheets(const std::vector<Table>& tables,
                                         const Declarations& declarations);

// The faults of cells and, beside them, those of the plan that was made of these: none that only
// follows from a fault of the same cell.
Faults with_plan_faults(const Faults& of_cells, const Faults& of_plan);

// Tells on stderr what is left out where faults keep the plan from being made.
void tell_left_out(const Faults& faults, const std::vector<std::string>& left_out);

// The faults of the plan, in words for sheets: its reader speaks of Placemarks where something is
// missing in all files.
Faults in_words_for_sheets(const Faults& faults);

}  // namespace lsos
