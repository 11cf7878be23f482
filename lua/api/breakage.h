// What scripts say of something that breaks.
#pragma once

#include <lua.hpp>

#include "mission/port/breakage.h"

namespace lsos {

// Reads { what = , part = , mode = , share = , is_repair = }. `call`: for messages. Throws
// InputError.
Breakage check_breakage(lua_State* L, int index, const char* call);

// rover:break_part {...}
int break_part(lua_State* L);

}  // namespace lsos
