#include "lua/runtime/module.h"

namespace lsos {

namespace {

constexpr const char* module_key = "lsos.module";

}  // namespace

void keep_lsos_module(lua_State* L) { lua_setfield(L, LUA_REGISTRYINDEX, module_key); }

void push_lsos_module(lua_State* L) { lua_getfield(L, LUA_REGISTRYINDEX, module_key); }

}  // namespace lsos
