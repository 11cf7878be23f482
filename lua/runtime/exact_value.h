// Values of Lua compared exactly. Lua's own equality takes 1 for 1.0 and 0.0 for -0.0, and no
// not-a-number for itself, though scripts can tell these apart.
#pragma once

#include <bit>
#include <cstdint>
#include <lua.hpp>

namespace lsos {

// A value without its contents: of texts, tables, functions and objects the address. It is used
// only to compare with values that are still there, so that addresses affect no result.
struct ExactValue {
  static constexpr int whole_number = LUA_NUMTYPES;  // beside LUA_TNUMBER, then a floating one

  int type = LUA_TNIL;
  std::uint64_t bits = 0;

  bool operator==(const ExactValue&) const = default;
};

inline ExactValue exact_value(lua_State* L, int index) {
  const int type = lua_type(L, index);
  switch (type) {
    case LUA_TNIL:
      return {};
    case LUA_TBOOLEAN:
      return {type, static_cast<std::uint64_t>(lua_toboolean(L, index))};
    case LUA_TNUMBER:
      if (lua_isinteger(L, index) != 0) {
        return {ExactValue::whole_number, static_cast<std::uint64_t>(lua_tointeger(L, index))};
      }
      return {type, std::bit_cast<std::uint64_t>(lua_tonumber(L, index))};
    default:
      return {type, std::bit_cast<std::uintptr_t>(lua_topointer(L, index))};
  }
}

// Whether no script can tell the values apart. Equal long texts may have two addresses.
inline bool are_exactly_equal(lua_State* L, int a, int b) {
  if (exact_value(L, a) == exact_value(L, b)) return true;
  return lua_type(L, a) == LUA_TSTRING && lua_rawequal(L, a, b) != 0;
}

}  // namespace lsos
