#include "lua/runtime/constructed_value.h"

#include <fmt/format.h>

#include <new>

#include "lua/runtime/state.h"
#include "lua/runtime/vec3.h"

namespace lsos {

namespace {

// Its address is the key of the metatable in the registry, so that a look-up creates no text.
constexpr char metatable_key = 0;

// The value without a check: only for the metatable's own functions, which scripts cannot reach.
ConstructedValue& made_at(lua_State* L, int index) {
  return *static_cast<ConstructedValue*>(lua_touserdata(L, index));
}

int collect(lua_State* L) {
  made_at(L, 1).~ConstructedValue();
  return 0;
}

int constructed_text(lua_State* L) {
  lua_pushfstring(L, "lsos.%s", made_at(L, 1).kind.c_str());
  return 1;
}

int refuse_access(lua_State* L) {
  throw std::runtime_error(
      fmt::format("what lsos.{} made cannot be looked into", made_at(L, 1).kind));
}

void push_constructed_metatable(lua_State* L) {
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &metatable_key) != LUA_TNIL) return;
  lua_pop(L, 1);
  lua_newtable(L);
  constexpr luaL_Reg functions[] = {{"__gc", collect},
                                    {"__tostring", guard<constructed_text>},
                                    {"__index", guard<refuse_access>},
                                    {"__newindex", guard<refuse_access>},
                                    {nullptr, nullptr}};
  luaL_setfuncs(L, functions, 0);
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_pushstring(L, "lsos object");
  lua_setfield(L, -2, "__name");  // for Lua's own messages
  // This is done last: if memory runs out before, the metatable is built anew next time.
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &metatable_key);
}

std::string with_article(const std::string& noun) {
  const bool vowel = std::string_view("aeio").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + noun;
}

}  // namespace

void push_constructed(lua_State* L, ConstructedValue made) {
  push_constructed_metatable(L);
  void* memory = lua_newuserdatauv(L, sizeof(ConstructedValue), 1);
  new (memory) ConstructedValue(std::move(made));
  lua_insert(L, -2);
  lua_setmetatable(L, -2);
}

const ConstructedValue* to_constructed(lua_State* L, int index) {
  auto* made = static_cast<const ConstructedValue*>(lua_touserdata(L, index));
  if (made == nullptr || lua_getmetatable(L, index) == 0) return nullptr;
  lua_rawgetp(L, LUA_REGISTRYINDEX, &metatable_key);
  const bool is_made = lua_rawequal(L, -1, -2) != 0;
  lua_pop(L, 2);
  return is_made ? made : nullptr;
}

std::string describe(lua_State* L, int index) {
  if (lua_isnoneornil(L, index)) return "nothing";
  if (const ConstructedValue* made = to_constructed(L, index)) return with_article(made->kind);
  if (is_vec3(L, index)) return "a vec3";
  if (lua_type(L, index) == LUA_TSTRING) return "a text";
  if (lua_type(L, index) == LUA_TUSERDATA) return "an object of the host";
  return with_article(luaL_typename(L, index));
}

}  // namespace lsos
