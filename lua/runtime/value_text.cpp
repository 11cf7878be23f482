#include "lua/runtime/value_text.h"

#include "base/utf8.h"
#include "lua/runtime/state.h"

namespace lsos {

void push_text(lua_State* L, int index) {
  constexpr std::int64_t instructions_per_number = 20;
  index = lua_absindex(L, index);
  const int type = lua_type(L, index);
  const bool is_plain =
      type == LUA_TNIL || type == LUA_TBOOLEAN || type == LUA_TNUMBER || type == LUA_TSTRING;
  if (is_plain) {
    if (type == LUA_TNUMBER) charge(L, instructions_per_number);
    luaL_tolstring(L, index, nullptr);
    return;
  }
  if (luaL_getmetafield(L, index, "__tostring") == LUA_TNIL) {
    lua_pushstring(L, luaL_typename(L, index));
    return;
  }
  lua_pushvalue(L, index);
  lua_call(L, 1, 1);
  if (lua_type(L, -1) != LUA_TSTRING) throw std::runtime_error("'__tostring' must give a text");
}

std::string key_text(lua_State* L, int index) {
  constexpr std::size_t bytes_max = 60;
  if (lua_type(L, index) != LUA_TSTRING) {
    push_text(L, index);
    std::string text = beginning(error_text(L, -1), bytes_max);
    lua_pop(L, 1);
    return text;
  }
  std::size_t size = 0;
  const char* bytes = lua_tolstring(L, index, &size);
  if (size <= bytes_max) return {bytes, size};
  return beginning({bytes, size}, bytes_max) + "...";
}

}  // namespace lsos
