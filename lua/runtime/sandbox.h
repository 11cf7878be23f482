// Functions that scripts can reach: an allow list of Lua's own, some of them replaced so that no
// script can hang the program, read an address, or see an order that differs from run to run.
#pragma once

#include <lua.hpp>
#include <string_view>

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

// Used in them.
inline constexpr lua_Integer values_max = 10'000;  // results of one call

inline std::string_view text_argument(lua_State* L, int index) {
  std::size_t size = 0;
  const char* text = luaL_checklstring(L, index, &size);
  return {text, size};
}

// Calls Lua's own function (upvalue 1) in this frame, so that its messages name the script.
inline int call_original(lua_State* L) { return lua_tocfunction(L, lua_upvalueindex(1))(L); }

}  // namespace lsos
