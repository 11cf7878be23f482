// `rover.drive`: what became of the last rover:follow or rover:follow_rover.
#include "lua/runtime/handle.h"

namespace lsos {

namespace {

DriveState drive_of(lua_State* L) { return handle_rover(L, drive_handle_type()).drive_state(); }

int drive_status(lua_State* L) {
  static constexpr const char* names[] = {"none", "driving", "arrived", "failed"};
  lua_pushstring(L, names[static_cast<int>(drive_of(L).status)]);
  return 1;
}

int drive_reason(lua_State* L) {
  lua_pushstring(L, drive_of(L).reason.c_str());
  return 1;
}

int drive_is_backward(lua_State* L) {
  lua_pushboolean(L, drive_of(L).is_backward);
  return 1;
}

int drive_is_blocked(lua_State* L) {
  lua_pushboolean(L, drive_of(L).is_blocked);
  return 1;
}

int drive_blocked_by(lua_State* L) {
  const std::string id = drive_of(L).blocked_by;
  if (id.empty()) {
    lua_pushnil(L);
  } else {
    lua_pushstring(L, id.c_str());
  }
  return 1;
}

int drive_next_point(lua_State* L) {
  lua_pushinteger(L, static_cast<lua_Integer>(drive_of(L).next_point) + 1);
  return 1;
}

int drive_remaining_m(lua_State* L) {
  push_quantity(L, drive_of(L).remaining_m);
  return 1;
}

}  // namespace

const HandleType& drive_handle_type() {
  static const HandleType type{
      "rover.drive",
      "What became of the last rover:follow or rover:follow_rover.",
      {{"status", drive_status, "text",
        "'none', 'driving', 'arrived' or 'failed'. Behind another rover it is 'driving' also while "
        "it "
        "stands and waits, and 'arrived' when all events of that one have ended."},
       {"reason", drive_reason, "text", "Why it failed, else ''."},
       {"remaining_m", drive_remaining_m, "number",
        "Along the path; behind another rover, to where that is."},
       {"next_point", drive_next_point, "integer", "Number of the path's point that comes next."},
       {"is_backward", drive_is_backward, "boolean",
        "It backs up, or did when it ended (see gear_changes of rover:follow)."},
       {"is_blocked", drive_is_blocked, "boolean",
        "It failed because of what lies ahead: ground it gets stuck on, another rover."},
       {"blocked_by", drive_blocked_by, "text",
        "The rover or asset that it would have touched; nil when there was none."}},
      {}};
  return type;
}

}  // namespace lsos
