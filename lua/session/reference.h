// Texts of lua/README.md and lua/library.d.lua, made from what is bound to Lua.
#pragma once

#include <string>
#include <vector>

namespace lsos {

struct HandleType;

std::string api_reference();
std::string api_library();

// Types of all objects that scripts are given: those of phases, then those of scenarios and
// prompts.
const std::vector<const HandleType*>& scripted_objects();

}  // namespace lsos
