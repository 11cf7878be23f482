#include "lua/api/breakage.h"

#include "lua/api/arguments.h"
#include "lua/runtime/handle.h"
#include "lua/runtime/reader.h"

namespace lsos {

Breakage check_breakage(lua_State* L, int index, const char* call) {
  luaL_checktype(L, index, LUA_TTABLE);
  Breakage breakage;
  Faults faults;
  TableReader t(L, index, call, {}, faults);
  t.text(required, "what", breakage.what, "wheel, steering, limb, antenna, battery or panel.");
  t.text(optional, "part", breakage.part, "A name (default: all).");
  t.text(optional, "mode", breakage.mode, "How it breaks.");
  t.number(optional, "share", breakage.share, any_number, "That is lost.");
  t.boolean(optional, "is_repair", breakage.is_repair, "It works again.");
  t.finish();
  faults.throw_if_errors();
  return breakage;
}

int break_part(lua_State* L) {
  RoverPort& rover = handle_rover(L, rover_handle_type());
  rover.break_part(check_breakage(L, 2, "rover:break_part"));
  return 0;
}

}  // namespace lsos
