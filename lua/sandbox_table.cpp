// table functions that loop inside C, bounded; and a sort that gives equal elements in equal order
// on every run (Lua's own picks pivots by the clock in bad cases).
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "lua/sandbox.h"
#include "lua/state.h"

namespace lsos {

namespace {

constexpr lua_Integer elements_max = 10'000'000;

// A metatable could answer for a length without an end.
void check_plain_table(lua_State* L, int index) {
  luaL_checktype(L, index, LUA_TTABLE);
  for (const char* name : {"__len", "__index", "__newindex"}) {
    if (luaL_getmetafield(L, index, name) == LUA_TNIL) continue;
    throw std::runtime_error(
        fmt::format("table functions take plain tables, not one with '{}'", name));
  }
}

int call_original(lua_State* L) { return lua_tocfunction(L, lua_upvalueindex(1))(L); }

// insert, remove, concat, unpack
int plain(lua_State* L) {
  check_plain_table(L, 1);
  charge(L, static_cast<std::int64_t>(lua_rawlen(L, 1)) / 8);
  return call_original(L);
}

int unpack(lua_State* L) {
  // ev.geometry and the like answer by metatable; unpack is bounded by Lua's stack anyway.
  if (lua_type(L, 1) == LUA_TTABLE) charge(L, static_cast<std::int64_t>(lua_rawlen(L, 1)) / 8);
  return call_original(L);
}

int move(lua_State* L) {
  check_plain_table(L, 1);
  if (!lua_isnoneornil(L, 5)) check_plain_table(L, 5);
  const lua_Integer first = luaL_checkinteger(L, 2);
  const lua_Integer last = luaL_checkinteger(L, 3);
  const double count = static_cast<double>(last) - static_cast<double>(first) + 1;
  if (count > elements_max) {
    throw std::runtime_error(
        fmt::format("table.move of {:.0f} elements; at most {}", count, elements_max));
  }
  charge(L, static_cast<std::int64_t>(count > 0 ? count : 0));
  return call_original(L);
}

// Stack: 1 the table, 2 the comparison or nil, 3 the elements.
bool is_less(lua_State* L, int a, int b) {
  if (lua_isnil(L, 2)) {
    lua_rawgeti(L, 3, a);
    lua_rawgeti(L, 3, b);
    const bool less = lua_compare(L, -2, -1, LUA_OPLT) != 0;
    lua_pop(L, 2);
    return less;
  }
  lua_pushvalue(L, 2);
  lua_rawgeti(L, 3, a);
  lua_rawgeti(L, 3, b);
  lua_call(L, 2, 1);
  const bool less = lua_toboolean(L, -1) != 0;
  lua_pop(L, 1);
  return less;
}

// Merge sort of positions: stable, and safe with a comparison that contradicts itself.
std::vector<int> sorted_positions(lua_State* L, int count) {
  std::vector<int> from(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) from[static_cast<std::size_t>(i)] = i + 1;
  std::vector<int> to(from.size());
  for (std::size_t width = 1; width < from.size(); width *= 2) {
    for (std::size_t begin = 0; begin < from.size(); begin += 2 * width) {
      const std::size_t middle = std::min(begin + width, from.size());
      const std::size_t end = std::min(begin + 2 * width, from.size());
      std::size_t left = begin, right = middle;
      for (std::size_t out = begin; out < end; ++out) {
        const bool take_right =
            left == middle || (right < end && is_less(L, from[right], from[left]));
        to[out] = take_right ? from[right++] : from[left++];
      }
    }
    std::swap(from, to);
  }
  return from;
}

int sort(lua_State* L) {
  check_plain_table(L, 1);
  if (!lua_isnoneornil(L, 2)) luaL_checktype(L, 2, LUA_TFUNCTION);
  lua_settop(L, 2);
  const auto count = static_cast<int>(lua_rawlen(L, 1));
  charge(L, static_cast<std::int64_t>(count) * 8);
  lua_createtable(L, count, 0);
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, 1, i);
    lua_rawseti(L, 3, i);
  }
  const std::vector<int> positions = sorted_positions(L, count);
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(L, 3, positions[static_cast<std::size_t>(i - 1)]);
    lua_rawseti(L, 1, i);
  }
  return 0;
}

}  // namespace

void replace_table_functions(lua_State* L) {
  constexpr luaL_Reg replacements[] = {{"insert", guard<plain>}, {"remove", guard<plain>},
                                       {"concat", guard<plain>}, {"unpack", guard<unpack>},
                                       {"move", guard<move>},    {"sort", guard<sort>}};
  for (const luaL_Reg& replacement : replacements) {
    lua_getfield(L, -1, replacement.name);
    lua_pushcclosure(L, replacement.func, 1);
    lua_setfield(L, -2, replacement.name);
  }
}

}  // namespace lsos
