// Functions that scripts can reach: an allow list of Lua's own, some of them replaced so that no
// script can hang the program, read an address, or see an order that differs from run to run.
#pragma once

#include <lua.hpp>

namespace lsos {

// Makes the shared, read-only libraries; called once for each state, before any script runs.
void make_sandbox(lua_State* L);

// Replacements, each in its own file; `L`'s top is the library's table.
void replace_string_functions(lua_State* L);
void replace_pattern_functions(lua_State* L);
void replace_table_functions(lua_State* L);
void replace_utf8_functions(lua_State* L);
// The same for the metatable of texts: '10' + 1 parses a number.
void replace_text_arithmetic(lua_State* L);

}  // namespace lsos
