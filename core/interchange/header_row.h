// Where the header of a sheet stands, and rows that are comments.
#pragma once

#include <string>

#include "interchange/table.h"
#include "plan/declaration.h"

namespace lsos {

// Removes rows of a sheet whose first text begins with '#', and titles above the header: those
// before the first row, of the first ten, with two headers or more that mean something. Returns a
// note where the header is not the first row; else "".
std::string find_header(Table& table, const Declarations& declarations);

}  // namespace lsos
