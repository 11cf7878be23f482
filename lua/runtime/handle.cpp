#include "lua/runtime/handle.h"

#include <fmt/format.h>

#include <cmath>

#include "lua/runtime/constructed_value.h"
#include "lua/runtime/read_only.h"
#include "lua/runtime/reader.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"

namespace lsos {

namespace {

// Keys are addresses, so that a look-up creates no text: the address of `type_key` is the key of
// the HandleType in a metatable, and the address of a HandleType is the key of its metatable in the
// registry.
constexpr char type_key = 0;

const HandleType& type_of_closure(lua_State* L) {
  return *static_cast<const HandleType*>(lua_touserdata(L, lua_upvalueindex(1)));
}

// Upvalue 2: method functions by name.
int read_key(lua_State* L) {
  constexpr std::int64_t instructions_per_read = 20;
  charge(L, instructions_per_read);
  const HandleType& type = type_of_closure(L);
  if (lua_type(L, 2) != LUA_TSTRING) refuse_handle_key(type, luaL_typename(L, 2));
  std::size_t size = 0;
  const char* bytes = lua_tolstring(L, 2, &size);
  const std::string_view key(bytes, size);
  for (const HandleField& field : type.fields) {
    if (key != field.name) continue;
    lua_settop(L, 1);
    return field.read(L);
  }
  lua_pushvalue(L, 2);
  lua_rawget(L, lua_upvalueindex(2));
  if (lua_isnil(L, -1)) refuse_handle_key(type, key_text(L, 2).c_str());
  return 1;
}

int refuse_handle_write(lua_State* L) {
  const HandleType& type = type_of_closure(L);
  throw std::runtime_error(fmt::format("{} is read-only, '{}' cannot be assigned", type.name,
                                       lua_type(L, 2) == LUA_TSTRING ? key_text(L, 2) : "?"));
}

int handle_text(lua_State* L) {
  lua_pushstring(L, type_of_closure(L).name);
  return 1;
}

void push_handle_metatable(lua_State* L, const HandleType& type) {
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &type) != LUA_TNIL) return;
  lua_pop(L, 1);
  lua_newtable(L);
  void* data = const_cast<HandleType*>(&type);
  lua_pushlightuserdata(L, data);
  lua_rawsetp(L, -2, &type_key);
  lua_pushlightuserdata(L, data);
  lua_newtable(L);
  for (const HandleMethod& method : type.methods) {
    lua_pushcfunction(L, method.function);
    lua_setfield(L, -2, method.name);
  }
  lua_pushcclosure(L, guard<read_key>, 2);
  lua_setfield(L, -2, "__index");
  lua_pushlightuserdata(L, data);
  lua_pushcclosure(L, type.write == nullptr ? guard<refuse_handle_write> : type.write, 1);
  lua_setfield(L, -2, "__newindex");
  lua_pushlightuserdata(L, data);
  lua_pushcclosure(L, guard<handle_text>, 1);
  lua_setfield(L, -2, "__tostring");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_pushstring(L, type.name);
  lua_setfield(L, -2, "__name");  // for Lua's own messages
  // This is done last: if memory runs out before, the metatable is built anew next time.
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &type);
}

}  // namespace

void refuse_handle_key(const HandleType& type, const char* key) {
  std::vector<std::string> known;
  for (const HandleField& field : type.fields) known.emplace_back(field.name);
  for (const HandleMethod& method : type.methods) known.emplace_back(method.name);
  throw std::runtime_error(
      fmt::format("{} has no '{}'{}", type.name, key, suggest_key(key, known)));
}

void push_handle(lua_State* L, const HandleType& type, ScriptInstance instance) {
  auto* id = static_cast<ScriptInstance*>(lua_newuserdatauv(L, sizeof(ScriptInstance), 1));
  *id = instance;
  push_handle_metatable(L, type);
  lua_setmetatable(L, -2);
}

const HandleType* handle_type(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TUSERDATA || lua_getmetatable(L, index) == 0) return nullptr;
  lua_rawgetp(L, -1, &type_key);
  const auto* type = static_cast<const HandleType*>(lua_touserdata(L, -1));
  lua_pop(L, 2);
  return type;
}

ScriptInstance handle_id(lua_State* L, const HandleType& type) {
  if (handle_type(L, 1) != &type) {
    throw std::runtime_error(fmt::format(
        "a method of {0} is called with a colon, as in {0}:{1}(); "
        "found {2} in place of {0}",
        type.name, type.methods.empty() ? "f" : type.methods.front().name, describe(L, 1)));
  }
  return *static_cast<const ScriptInstance*>(lua_touserdata(L, 1));
}

RoverPort& handle_rover(lua_State* L, const HandleType& type) {
  const ScriptInstance id = handle_id(L, type);
  return id < 0 ? context(L).interactive_rovers->rover(id) : handle_call(L, type).phase.rover;
}

const EventCall& handle_call(lua_State* L, const HandleType& type) {
  const ScriptInstance id = handle_id(L, type);
  const EventCall* call = context(L).call;
  if (call == nullptr || call->instance != id) {
    throw std::runtime_error(
        fmt::format("{} belongs to an event that is not running now; do not keep it", type.name));
  }
  return *call;
}

void push_quantity(lua_State* L, double value) {
  if (std::isnan(value)) {
    lua_pushnil(L);
  } else {
    lua_pushnumber(L, value);
  }
}

}  // namespace lsos
