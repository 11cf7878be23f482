// A plan as sheets that a planner edits.
#pragma once

#include <string>
#include <vector>

#include "interchange/place_book.h"
#include "interchange/table.h"
#include "plan/declaration.h"
#include "plan/kml_source.h"

namespace lsos {

// The sheets Mission, Rovers, Assets, Places and Events of a plan's things, or with `is_one` all of
// them as one with a column Type. Each cell reads back to exactly the value of the plan.
std::vector<Table> sheet_tables(const KmlSource& things, const Declarations& declarations,
                                const std::vector<Landmark>& landmarks, bool is_one);

}  // namespace lsos
