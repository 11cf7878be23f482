// A soil from a file of the user's, for instruments that take one.
#pragma once

#include <string>

#include "terrain/spec/soil.h"

namespace lsos {

// A Lua file that returns lsos.soil {...} or a plain table with the same keys. Throws InputError.
Soil read_soil_file(const std::string& file);

}  // namespace lsos
