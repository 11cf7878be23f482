// Commands of `rover` to drive: along a path, and behind another rover.
#pragma once

#include <lua.hpp>

namespace lsos {

int command_follow(lua_State* L);
int command_follow_rover(lua_State* L);

}  // namespace lsos
