// Files that are imported: sheets, maps, outlines as tables, and what is wrong with them.
#pragma once

#include <map>
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

// The faults of the plan, in words for sheets: its reader speaks of Placemarks where something is
// missing in all files.
Faults in_words_for_sheets(const Faults& faults);

}  // namespace lsos
