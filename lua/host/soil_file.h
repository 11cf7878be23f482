// Reads a soil from a user's file, for instruments that take one.
#pragma once

#include <string>

#include "terrain/spec/soil.h"

namespace lsos {

// Reads a Lua file that returns lsos.soil {...} or a plain table with the same keys. Throws
// InputError.
Soil read_soil_file(const std::string& file);

}  // namespace lsos
