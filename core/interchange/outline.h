// Plans as outlines: a text with a line or an item for each event. The grammar is in
// plans/README.md, "A plan as an outline".
#pragma once

#include <string>
#include <vector>

#include "interchange/place_book.h"
#include "interchange/table.h"
#include "plan/declaration.h"
#include "plan/kml_source.h"

namespace lsos {

// The things of an outline as tables. Throws InputError with all lines that are not understood, and
// what would be.
std::vector<Table> read_outline(const std::string& bytes, const std::string& file,
                                const Declarations& declarations);

// A plan's things, see plan_things(), as an outline that reads back equal: places by name, then by
// day and rover what is done, in words.
std::string outline_of(const KmlSource& plan, const Declarations& declarations,
                       const std::vector<Landmark>& landmarks = {});

}  // namespace lsos
