// Lua tables as JSON, for the fields of notes.
#pragma once

#include <lua.hpp>
#include <string>

namespace lsos {

// The table at `index` (or nil: empty) as a JSON object with sorted keys. Throws
// std::runtime_error naming the key of what has no JSON form.
std::string fields_json(lua_State* L, int index);

}  // namespace lsos
