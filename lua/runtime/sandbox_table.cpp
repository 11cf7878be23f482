// Bounded versions of table functions that loop inside C, and a sort that leaves equal elements in
// the same order on every run (Lua's own picks pivots by the clock in bad cases).
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lua/runtime/sandbox.h"
#include "lua/runtime/state.h"

namespace lsos {

namespace {

constexpr lua_Integer elements_max = 10'000'000;

// Refuses tables whose metatable could report an endless length.
void check_plain_table(lua_State* L, int index) {
  luaL_checktype(L, index, LUA_TTABLE);
  for (const char* name : {"__len", "__index", "__newindex"}) {
    if (luaL_getmetafield(L, index, name) == LUA_TNIL) continue;
    throw std::runtime_error(
        fmt::format("table functions take plain tables, not one with '{}'", name));
  }
}

// insert and remove, charged by the elements that they move.
int shifting(lua_State* L) {
  check_plain_table(L, 1);
  const auto length = static_cast<lua_Integer>(lua_rawlen(L, 1));
  // With a position insert has three arguments, remove two.
  const bool is_remove = lua_gettop(L) == 2 && lua_toboolean(L, lua_upvalueindex(2)) != 0;
  if (lua_gettop(L) == 3 || is_remove) {
    const lua_Integer position = luaL_checkinteger(L, 2);
    if (position >= 1 && position <= length) charge(L, 4 * (length - position));
  }
  return call_original(L);
}

int concat(lua_State* L) {
  check_plain_table(L, 1);
  const lua_Integer first = luaL_optinteger(L, 3, 1);
  const auto length = static_cast<lua_Integer>(lua_rawlen(L, 1));
  const lua_Integer last = luaL_optinteger(L, 4, length);
  // Past the end of the list concat raises an error. A number in the list becomes a text.
  if (last >= first && first <= length) {
    charge(L, 20 * (std::min(last, length) - std::max<lua_Integer>(1, first) + 1));
  }
  const int count = call_original(L);
  charge_bytes(L, lua_rawlen(L, -1));
  return count;
}

int unpack(lua_State* L) {
  // The length is taken with metatables, as ev.geometry needs.
  const lua_Integer first = luaL_optinteger(L, 2, 1);
  const lua_Integer last = lua_isnoneornil(L, 3) ? luaL_len(L, 1) : luaL_checkinteger(L, 3);
  const double count = static_cast<double>(last) - static_cast<double>(first) + 1;
  if (count > values_max) {
    throw std::runtime_error(
        fmt::format("table.unpack of {:.0f} values; at most {}", count, values_max));
  }
  charge(L, static_cast<std::int64_t>(std::max(0.0, count)));
  lua_settop(L, 1);
  lua_pushinteger(L, first);
  lua_pushinteger(L, last);
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
  charge(L, 4 * static_cast<std::int64_t>(std::max(0.0, count)));
  return call_original(L);
}

// Stack: 1 the table, 2 the comparison or nil, 3 the elements.
bool is_less(lua_State* L, int a, int b) {
  charge(L, instructions_per_call);
  if (lua_isnil(L, 2)) {
    lua_rawgeti(L, 3, a);
    lua_rawgeti(L, 3, b);
    if (lua_type(L, -1) == LUA_TSTRING && lua_type(L, -2) == LUA_TSTRING) {
      charge_bytes(L, std::min(lua_rawlen(L, -1), lua_rawlen(L, -2)));
    }
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

int pack(lua_State* L) {
  charge(L, 2 * std::int64_t{lua_gettop(L)});
  return call_original(L);
}

}  // namespace

void replace_table_functions(lua_State* L) {
  constexpr luaL_Reg replacements[] = {{"insert", guard<shifting>}, {"remove", guard<shifting>},
                                       {"concat", guard<concat>},   {"unpack", guard<unpack>},
                                       {"move", guard<move>},       {"sort", guard<sort>},
                                       {"pack", guard<pack>}};
  for (const luaL_Reg& replacement : replacements) {
    lua_getfield(L, -1, replacement.name);
    lua_pushboolean(L, std::string_view(replacement.name) == "remove");
    lua_pushcclosure(L, replacement.func, 2);
    lua_setfield(L, -2, replacement.name);
  }
}

}  // namespace lsos
