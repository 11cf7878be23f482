// Keys of tables in an order that is the same in every run.
#pragma once

#include <lua.hpp>

namespace lsos {

// Keys of the table at `index` as a new array, pushed: numbers ascending, then strings by bytes.
// Raises when another key is among them.
void push_sorted_keys(lua_State* L, int index);

}  // namespace lsos
