#include "lua/made.h"

#include <fmt/format.h>

#include <new>

#include "lua/state.h"
#include "lua/vec3.h"

namespace lsos {

namespace {

constexpr const char* metatable_name = "lsos.made";

Made& made_at(lua_State* L, int index) {
  return *static_cast<Made*>(luaL_checkudata(L, index, metatable_name));
}

int collect(lua_State* L) {
  made_at(L, 1).~Made();
  return 0;
}

int to_string(lua_State* L) {
  lua_pushfstring(L, "lsos.%s", made_at(L, 1).kind.c_str());
  return 1;
}

int refuse_access(lua_State* L) {
  throw std::runtime_error(
      fmt::format("what lsos.{} made cannot be looked into", made_at(L, 1).kind));
}

void push_metatable(lua_State* L) {
  if (luaL_newmetatable(L, metatable_name) == 0) return;
  constexpr luaL_Reg functions[] = {{"__gc", collect},
                                    {"__tostring", guard<to_string>},
                                    {"__index", guard<refuse_access>},
                                    {"__newindex", guard<refuse_access>},
                                    {nullptr, nullptr}};
  luaL_setfuncs(L, functions, 0);
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
}

std::string with_article(const std::string& noun) {
  const bool vowel = std::string_view("aeio").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + noun;
}

}  // namespace

void push_made(lua_State* L, Made made) {
  push_metatable(L);
  void* memory = lua_newuserdatauv(L, sizeof(Made), 1);
  new (memory) Made(std::move(made));
  lua_insert(L, -2);
  lua_setmetatable(L, -2);
}

const Made* to_made(lua_State* L, int index) {
  return static_cast<const Made*>(luaL_testudata(L, index, metatable_name));
}

std::string describe(lua_State* L, int index) {
  if (lua_isnoneornil(L, index)) return "nothing";
  if (const Made* made = to_made(L, index)) return with_article(made->kind);
  if (is_vec3(L, index)) return "a vec3";
  if (lua_type(L, index) == LUA_TSTRING) return "a text";
  if (lua_type(L, index) == LUA_TUSERDATA) return "an object of the host";
  return with_article(luaL_typename(L, index));
}

}  // namespace lsos
