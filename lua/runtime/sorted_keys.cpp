#include "lua/runtime/sorted_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <string_view>
#include <vector>

#include "lua/runtime/state.h"

namespace lsos {

namespace {

struct Key {
  bool is_text = false;
  bool is_integer = false;
  lua_Integer integer = 0;
  lua_Number number = 0;
  std::string_view text;  // the table holds it
};

bool comes_before(const Key& a, const Key& b) {
  if (a.is_text != b.is_text) return b.is_text;
  if (a.is_text) return a.text < b.text;
  if (a.is_integer && b.is_integer) return a.integer < b.integer;
  return a.number < b.number;
}

}  // namespace

void push_sorted_keys(lua_State* L, int index) {
  // Cost of sorting a key and of its entry in the new table, charged beforehand: nothing checks the
  // budget meanwhile.
  constexpr std::int64_t instructions_per_key = 8;
  index = lua_absindex(L, index);
  std::vector<Key> keys;
  lua_pushnil(L);
  while (lua_next(L, index) != 0) {
    lua_pop(L, 1);
    charge(L, instructions_per_key + std::bit_width(keys.size()));
    if (lua_type(L, -1) == LUA_TSTRING) charge_bytes(L, lua_rawlen(L, -1));
    Key key;
    if (lua_type(L, -1) == LUA_TSTRING) {
      key.is_text = true;
      std::size_t size = 0;
      const char* bytes = lua_tolstring(L, -1, &size);
      key.text = {bytes, size};
    } else if (lua_type(L, -1) == LUA_TNUMBER) {
      key.is_integer = lua_isinteger(L, -1) != 0;
      key.integer = key.is_integer ? lua_tointeger(L, -1) : 0;
      key.number = lua_tonumber(L, -1);
    } else {
      throw std::runtime_error(
          fmt::format("a key is a {}: only numbers and texts have an order", luaL_typename(L, -1)));
    }
    keys.push_back(key);
  }
  std::ranges::sort(keys, comes_before);
  lua_createtable(L, static_cast<int>(keys.size()), 0);
  lua_Integer position = 0;
  for (const Key& key : keys) {
    if (key.is_text) lua_pushlstring(L, key.text.data(), key.text.size());
    if (!key.is_text && key.is_integer) lua_pushinteger(L, key.integer);
    if (!key.is_text && !key.is_integer) lua_pushnumber(L, key.number);
    lua_rawseti(L, -2, ++position);
  }
}

}  // namespace lsos
