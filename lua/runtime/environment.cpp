#include "lua/runtime/environment.h"

#include <fmt/format.h>

#include <stdexcept>

#include "lua/runtime/read_only.h"
#include "lua/runtime/state.h"

namespace lsos {

namespace {

constexpr const char* environment_key = "lsos.environment";

}  // namespace

void keep_globals(lua_State* L) { lua_setfield(L, LUA_REGISTRYINDEX, environment_key); }

// The environment is an empty table in front of the shared one, so that a script's own raw writes
// reach no other script.
void push_environment(lua_State* L) {
  lua_newtable(L);
  lua_newtable(L);
  lua_getfield(L, LUA_REGISTRYINDEX, environment_key);
  lua_setfield(L, -2, "__index");
  lua_pushliteral(L, "");
  lua_pushcclosure(L, guard<refuse_assignment>, 1);
  lua_setfield(L, -2, "__newindex");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
}

void push_open_environment(lua_State* L) {
  lua_newtable(L);
  lua_newtable(L);
  lua_getfield(L, LUA_REGISTRYINDEX, environment_key);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
}

void run_within(lua_State* L, const Script& script) {
  if (!script.unread.empty()) {
    throw std::runtime_error(fmt::format("{} {}", script.file, script.unread));
  }
  charge_bytes(L, script.source.size());  // no count hook sees the parser
  if (const auto failure = load_text(L, script.source, script.file)) {
    throw std::runtime_error(failure->message);
  }
  push_environment(L);
  lua_setupvalue(L, -2, 1);  // _ENV
  lua_call(L, 0, 1);
}

}  // namespace lsos
