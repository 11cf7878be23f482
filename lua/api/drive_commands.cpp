#include "lua/api/drive_commands.h"

#include <stdexcept>
#include <string>

#include "lua/api/arguments.h"
#include "lua/api/route.h"
#include "lua/runtime/handle.h"
#include "lua/runtime/reader.h"
#include "lua/runtime/state.h"

namespace lsos {

namespace {

FollowSettings check_settings(lua_State* L, int argument) {
  FollowSettings settings;
  if (lua_isnoneornil(L, argument)) return settings;
  luaL_checktype(L, argument, LUA_TTABLE);
  Faults faults;
  TableReader t(L, argument, "rover:follow", {}, faults);
  t.number(optional, "speed_mps", settings.speed_mps, positive, "Driving speed.");
  t.number(optional, "arrival_radius_m", settings.arrival_radius_m, positive, "Arrived within.");
  t.boolean(optional, "crab", settings.is_crabbing,
            "Along the path without turning into it; rovers that can.");
  t.boolean(optional, "keeps_room_to_turn", settings.keeps_room_to_turn,
            "Before a rover that stands it ends so early that it can still turn on the spot.");
  t.number(optional, "stray_max_m", settings.cross_track_max_m, positive,
           "Farther than this from the path the drive fails (default: however far).");
  t.number(optional, "slope_max_rad", settings.slope_max_rad, positive,
           "On a steeper slope it warns, once a drive (default: none is too steep).");
  t.finish();
  faults.throw_if_errors();
  return settings;
}

}  // namespace

int command_follow(lua_State* L) {
  RoverPort& rover = rover_of(L);
  lua_settop(L, 3);
  const Path3 path = read_path(L, 2, "rover:follow");
  if (path.empty()) throw std::runtime_error("rover:follow wants at least one waypoint");
  FollowSettings settings = check_settings(L, 3);
  settings.gear_changes = read_gear_changes(L, 2, path.size(), "rover:follow");
  rover.follow(path, settings);
  return 0;
}

int command_follow_rover(lua_State* L) {
  RoverPort& rover = rover_of(L);
  lua_settop(L, 3);
  PursuitSettings settings;
  settings.leader_id = luaL_checkstring(L, 2);
  if (!lua_isnil(L, 3)) {
    luaL_checktype(L, 3, LUA_TTABLE);
    Faults faults;
    TableReader t(L, 3, "rover:follow_rover", {}, faults);
    t.number(optional, "distance_m", settings.distance_m, positive, "Kept along the track.");
    t.number(optional, "speed_mps", settings.speed_mps, positive, "The greatest.");
    t.finish();
    faults.throw_if_errors();
  }
  rover.follow_rover(settings);
  return 0;
}

}  // namespace lsos
