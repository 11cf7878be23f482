// The lsos module of a state, which `require 'lsos'` returns.
#pragma once

#include <lua.hpp>

namespace lsos {

// Takes the table at the top of the stack as the module. Once a state.
void keep_lsos_module(lua_State* L);
void push_lsos_module(lua_State* L);

}  // namespace lsos
