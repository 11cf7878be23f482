// Tables that scripts can read and not write.
#pragma once

#include <lua.hpp>

namespace lsos {

// Replaces the table at the top of the stack by a read-only view of it; `name` is for messages.
// A missing key is an error with the nearest name.
void make_read_only(lua_State* L, const char* name);

// A __newindex that refuses what is assigned; its upvalue is the table's name, "" for the globals.
int refuse_assignment(lua_State* L);

}  // namespace lsos
