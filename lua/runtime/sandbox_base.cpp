#include "lua/runtime/sandbox_base.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <string>
#include <string_view>
#include <vector>

#include "lua/runtime/json.h"
#include "lua/runtime/module.h"
#include "lua/runtime/shared_script.h"
#include "lua/runtime/sorted_keys.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"

namespace lsos {

namespace {

int sorted_next(lua_State* L) {
  // Upvalues: the table, its keys, how many were given out.
  lua_Integer given = lua_tointeger(L, lua_upvalueindex(3));
  for (;;) {
    lua_rawgeti(L, lua_upvalueindex(2), ++given);
    if (lua_isnil(L, -1)) return 1;
    lua_pushvalue(L, -1);
    lua_rawget(L, lua_upvalueindex(1));
    if (!lua_isnil(L, -1)) break;
    lua_pop(L, 2);  // removed since the loop began
  }
  lua_pushinteger(L, given);
  lua_replace(L, lua_upvalueindex(3));
  return 2;
}

int pairs(lua_State* L) {
  luaL_checkany(L, 1);
  if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(L, 1);
    lua_call(L, 1, 3);
    return 3;
  }
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 1);
  push_sorted_keys(L, 1);
  lua_pushinteger(L, 0);
  lua_pushcclosure(L, guard<sorted_next>, 3);
  return 1;
}

// tonumber with a charge. Upvalue 1: Lua's own function.
int to_number(lua_State* L) {
  if (lua_type(L, 1) == LUA_TSTRING) charge_bytes(L, 4 * lua_rawlen(L, 1));
  return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

int to_text(lua_State* L) {
  luaL_checkany(L, 1);
  push_text(L, 1);
  return 1;
}

// Called after a protected call that failed: passes on an error that no script may catch. Any other
// error is charged what a C++ exception costs.
void pass_on_fatal(lua_State* L, int status) {
  constexpr std::int64_t instructions_per_exception = 300;
  LuaContext& ctx = context(L);
  if (status == LUA_ERRMEM) note_memory_spent(L);
  if (!ctx.spent.empty()) {
    lua_pushlstring(L, ctx.spent.data(), ctx.spent.size());
    lua_error(L);
  }
  if (ctx.internal_error) lua_error(L);
  charge(L, instructions_per_exception);
}

int protected_call(lua_State* L) {
  luaL_checkany(L, 1);
  const int status = lua_pcall(L, lua_gettop(L) - 1, LUA_MULTRET, 0);
  if (status != LUA_OK) pass_on_fatal(L, status);
  lua_pushboolean(L, status == LUA_OK);
  lua_insert(L, 1);
  return lua_gettop(L);
}

// Error handler of xpcall. A spent budget raises inside the count hook, where no further hook
// fires, so the script's handler (upvalue 1) could then loop without end.
int handle_error(lua_State* L) {
  constexpr std::int64_t instructions_per_handler = 200;  // called again if it raises
  if (!context(L).spent.empty()) return 1;
  charge(L, instructions_per_handler);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, 1, 1);
  return 1;
}

int protected_call_with_handler(lua_State* L) {
  luaL_checktype(L, 2, LUA_TFUNCTION);
  lua_pushvalue(L, 2);
  lua_pushcclosure(L, handle_error, 1);
  lua_copy(L, 1, 2);
  lua_replace(L, 1);  // handler, function, arguments
  const int status = lua_pcall(L, lua_gettop(L) - 2, LUA_MULTRET, 1);
  if (status != LUA_OK) pass_on_fatal(L, status);
  lua_pushboolean(L, status == LUA_OK);
  lua_replace(L, 1);
  return lua_gettop(L);
}

bool is_protected(lua_State* L, int index) {
  if (luaL_getmetafield(L, index, "__metatable") == LUA_TNIL) return false;
  lua_pop(L, 1);
  return true;
}

int set_metatable(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  luaL_argexpected(L, lua_istable(L, 2) || lua_isnil(L, 2), 2, "nil or table");
  if (is_protected(L, 1)) throw std::runtime_error("this metatable cannot be changed");
  if (lua_istable(L, 2)) {
    // Finalisers and weak tables act when the collector runs, which is not repeatable. Set after
    // this call, neither has an effect: Lua checks for '__gc' only here, and '__mode' is hidden
    // from the collector (see ScriptMemory). The metatable thus stays the script's own, to change.
    for (const char* name : {"__gc", "__mode"}) {
      lua_pushstring(L, name);
      lua_rawget(L, 2);
      if (!lua_isnil(L, -1)) {
        throw std::runtime_error(fmt::format(
            "a metatable with '{}' is not allowed: the collector's moment is not repeatable",
            name));
      }
      lua_pop(L, 1);
    }
    lua_pushvalue(L, 2);
    context(L).memory.note_metatable(L);
    lua_pop(L, 1);
  }
  lua_settop(L, 2);
  lua_setmetatable(L, 1);
  return 1;
}

int get_metatable(lua_State* L) {
  luaL_checkany(L, 1);
  if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL) return 1;
  if (lua_getmetatable(L, 1) == 0) lua_pushnil(L);
  return 1;
}

int raw_set(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  luaL_checkany(L, 2);
  luaL_checkany(L, 3);
  if (is_protected(L, 1)) throw std::runtime_error("rawset on a table that is read-only");
  lua_settop(L, 3);
  lua_rawset(L, 1);
  return 1;
}

int require(lua_State* L) {
  const std::string name = luaL_checkstring(L, 1);
  if (name == "lsos") {
    push_lsos_module(L);
  } else {
    push_shared_script(L, name);
  }
  return 1;
}

// Writes a note "print" into the log; at a prompt the line is printed.
int print(lua_State* L) {
  constexpr std::int64_t instructions_per_print = 200;
  std::string line;
  const int count = lua_gettop(L);
  for (int i = 1; i <= count; ++i) {
    push_text(L, i);
    charge_bytes(L, lua_rawlen(L, -1));
    if (line.size() + lua_rawlen(L, -1) > note_bytes_max) {
      throw std::runtime_error(
          fmt::format("print of more than {} KiB in one line", note_bytes_max >> 10));
    }
    line += (i > 1 ? "\t" : "") + error_text(L, -1);
    lua_pop(L, 1);
  }
  charge(L, instructions_per_print);
  lua_settop(L, 0);
  if (context(L).interactive_rovers != nullptr) {
    context(L).interactive_rovers->say(line);
    return 0;
  }
  const EventCall& call = running_call(L, "print");
  lua_newtable(L);
  lua_pushlstring(L, line.data(), line.size());
  lua_setfield(L, 1, "text");
  write_note(L, call, "print", fields_json(L, 1));
  return 0;
}

}  // namespace

void add_base_functions(lua_State* L) {
  constexpr luaL_Reg functions[] = {{"pairs", guard<pairs>},
                                    {"tostring", guard<to_text>},
                                    {"pcall", guard<protected_call>},
                                    {"xpcall", guard<protected_call_with_handler>},
                                    {"setmetatable", guard<set_metatable>},
                                    {"getmetatable", guard<get_metatable>},
                                    {"rawset", guard<raw_set>},
                                    {"require", guard<require>},
                                    {"print", guard<print>},
                                    {nullptr, nullptr}};
  luaL_setfuncs(L, functions, 0);
  lua_getglobal(L, "tonumber");
  lua_pushcclosure(L, guard<to_number>, 1);
  lua_setfield(L, -2, "tonumber");
}

}  // namespace lsos
