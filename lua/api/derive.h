// lsos.derive: a rover or asset that differs from another one in some of its numbers.
#pragma once

#include <lua.hpp>

namespace lsos {

// lsos.derive(base, changes), called while a script of rovers/ loads. Returns what the constructor
// makes of the base's table with the changes merged into it: a table changes the keys that a part
// was made from, a list of named parts is changed by their names, `false` removes a part, and
// anything else replaces the base's value. `assumptions` are added to those of the base, with a
// sentence that lists the changes. Throws std::runtime_error that names the key.
int derive(lua_State* L);

}  // namespace lsos
