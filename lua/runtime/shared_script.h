// Scripts of lib/, which other scripts share by `require 'lib/NAME'`.
#pragma once

#include <lua.hpp>
#include <string>

namespace lsos {

// Pushes what the script of lib/ returned, a table, for reading only. It runs once for each script
// that loads, so that no two share what it holds. Throws std::runtime_error when no script is
// loading, or when there is no such script, it requires itself or returns no table.
void push_shared_script(lua_State* L, const std::string& name);

// Forgets what has been run for the script that loaded before.
void forget_shared_scripts(lua_State* L);

}  // namespace lsos
