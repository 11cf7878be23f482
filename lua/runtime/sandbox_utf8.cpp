// utf8 functions, charged by the bytes that they read.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "lua/runtime/sandbox.h"
#include "lua/runtime/state.h"

namespace lsos {

namespace {

constexpr std::size_t bytes_per_instruction = 4;

void charge_characters(lua_State* L, std::size_t bytes) {
  charge(L, static_cast<std::int64_t>(bytes / bytes_per_instruction));
}

int charged(lua_State* L) {
  if (lua_type(L, 1) == LUA_TSTRING) charge_characters(L, lua_rawlen(L, 1));
  return call_original(L);
}

// utf8.char: a value is at most 6 bytes.
int character(lua_State* L) {
  charge(L, 4 * std::int64_t{lua_gettop(L)});
  return call_original(L);
}

int code_point(lua_State* L) {
  std::size_t size = 0;
  luaL_checklstring(L, 1, &size);
  const auto bytes = static_cast<lua_Integer>(size);
  const lua_Integer first = luaL_optinteger(L, 2, 1), last = luaL_optinteger(L, 3, first);
  const auto from_begin = [&](lua_Integer i) {
    return i >= 0 ? std::min(i, bytes) : std::max(-bytes, i) + bytes + 1;
  };
  const lua_Integer count = from_begin(last) - from_begin(first) + 1;
  if (count > values_max) {
    throw std::runtime_error(
        fmt::format("utf8.codepoint of {} bytes; at most {}", count, values_max));
  }
  charge(L, std::max<lua_Integer>(0, count));
  return call_original(L);
}

// Iterator of utf8.codes. Upvalue 1: Lua's own iterator, which skips the continuation bytes of a
// character.
int next_code(lua_State* L) {
  std::size_t size = 0;
  const char* text = luaL_checklstring(L, 1, &size);
  auto at = static_cast<std::size_t>(std::max<lua_Integer>(0, luaL_checkinteger(L, 2)));
  std::size_t skipped = 0;
  for (; at < size && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80; ++at) ++skipped;
  charge_characters(L, skipped);
  return call_original(L);
}

int codes(lua_State* L) {
  const int count = call_original(L);
  if (count == 3 && lua_iscfunction(L, -3) != 0) {
    lua_pushvalue(L, -3);
    lua_pushcclosure(L, guard<next_code>, 1);
    lua_replace(L, -4);
  }
  return count;
}

}  // namespace

void replace_utf8_functions(lua_State* L) {
  constexpr luaL_Reg replacements[] = {{"len", guard<charged>},
                                       {"offset", guard<charged>},
                                       {"char", guard<character>},
                                       {"codepoint", guard<code_point>},
                                       {"codes", guard<codes>}};
  for (const luaL_Reg& replacement : replacements) {
    lua_getfield(L, -1, replacement.name);
    lua_pushcclosure(L, replacement.func, 1);
    lua_setfield(L, -2, replacement.name);
  }
}

}  // namespace lsos
