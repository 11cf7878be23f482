// Tables that scripts can read and not write: views, empty tables in front of what they show.
#pragma once

#include <lua.hpp>

namespace lsos {

// Whose a table is: what the program has, or what a script made, whose functions and tables may
// hold something that changes.
enum class Maker { program, script };

// Replaces the table at the top of the stack by a read-only view of it; `name` is for messages.
// A missing key is an error with the nearest name.
void make_read_only(lua_State* L, const char* name, Maker maker = Maker::program);

// Whether the value at `index` is a view, or the environment of a script, which is one too.
bool is_view(lua_State* L, int index);
// Whether the table at `index` is the metatable of a view or of what a view shows.
bool is_metatable_of_view(lua_State* L, int index);
// Pushes the table that the view at `index` shows if a script made it.
bool push_shown_script(lua_State* L, int view);

// A __newindex that refuses what is assigned; its upvalue is the table's name, "" for the globals.
int refuse_assignment(lua_State* L);

}  // namespace lsos
