// `rover`: a rover's state at the last exchange, and the commands to it.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "lua/api/arguments.h"
#include "lua/api/breakage.h"
#include "lua/api/drive_commands.h"
#include "lua/api/resources.h"
#include "lua/api/route.h"
#include "lua/runtime/handle.h"
#include "lua/runtime/reader.h"
#include "lua/runtime/state.h"
#include "lua/runtime/vec3.h"

namespace lsos {

namespace {

// Cost of sampling ground or sky, which may have to be generated first.
constexpr std::int64_t instructions_per_sample = 1000;

const RoverView& view_of(lua_State* L) { return rover_of(L).view(); }

template <auto member>
int quantity(lua_State* L) {
  push_quantity(L, view_of(L).*member);
  return 1;
}

template <auto member>
int push_member_text(lua_State* L) {
  lua_pushstring(L, (view_of(L).*member).c_str());
  return 1;
}

int position(lua_State* L) {
  push_vec3(L, view_of(L).p_S_m);
  return 1;
}

int is_adjusting(lua_State* L) {
  lua_pushboolean(L, view_of(L).is_adjusting);
  return 1;
}

int stance_fault(lua_State* L) {
  const std::string& fault = view_of(L).stance_fault;
  if (fault.empty()) {
    lua_pushnil(L);
  } else {
    lua_pushstring(L, fault.c_str());
  }
  return 1;
}

int set_posture(lua_State* L) {
  RoverPort& rover = rover_of(L);
  luaL_checktype(L, 2, LUA_TTABLE);
  PostureRequest request;
  Faults faults;
  TableReader t(L, 2, "rover:set_posture", {}, faults);
  t.text(optional, "stance", request.stance, "A configuration of the rover.");
  t.number(optional, "height_m", request.height_m, positive, "Under the chassis.");
  t.boolean(optional, "level", request.is_level, "Kept level, else parallel to the ground.");
  t.number(optional, "duration_s", request.duration_s, not_negative, "How long it takes.");
  t.finish();
  faults.throw_if_errors();
  lua_pushnumber(L, rover.set_posture(request));
  return 1;
}

int slope_max(lua_State* L) {
  const double slope_rad = rover_of(L).view().slope_max_rad;
  push_quantity(L, std::isfinite(slope_rad) ? slope_rad : not_modelled);
  return 1;
}

int is_parked(lua_State* L) {
  lua_pushboolean(L, view_of(L).is_parked);
  return 1;
}

int drive(lua_State* L) {
  push_handle(L, drive_handle_type(), handle_id(L, rover_handle_type()));
  return 1;
}

int battery(lua_State* L) {
  if (rover_of(L).power().view().has_battery) {
    push_handle(L, battery_handle_type(), handle_id(L, rover_handle_type()));
  } else {
    lua_pushnil(L);
  }
  return 1;
}

int antennas(lua_State* L) {
  push_handle(L, antennas_handle_type(), handle_id(L, rover_handle_type()));
  return 1;
}

int panels(lua_State* L) {
  push_handle(L, panels_handle_type(), handle_id(L, rover_handle_type()));
  return 1;
}

int work(lua_State* L) {
  const double power_w = luaL_checknumber(L, 2);
  if (!(power_w >= 0 && std::isfinite(power_w))) {
    throw std::runtime_error(
        fmt::format("rover:work({}): a power of 0 W or more is wanted", power_w));
  }
  rover_of(L).power().set_work(power_w);
  return 0;
}

// Charges for planning, the most expensive work that a script can request: a kilometre may take a
// second or more. A mission's own route of hundreds of legs must fit the budget, though most of it
// is planned before the event requests it.
void charge_planning(lua_State* L, const Path3& waypoints, std::int64_t first,
                     const Vec3& from_S_m) {
  constexpr std::int64_t instructions_per_plan = 150'000, instructions_per_leg = 1000;
  constexpr double instructions_per_m = 2.5, length_max_m = 1e9;
  double length_m = 0;
  Vec3 before_S_m = from_S_m;
  for (auto i = static_cast<std::size_t>(first - 1); i < waypoints.size(); ++i) {
    length_m += (waypoints[i] - before_S_m).norm();
    before_S_m = waypoints[i];
  }
  const std::int64_t legs = static_cast<std::int64_t>(waypoints.size()) - first + 1;
  const std::int64_t instructions =
      instructions_per_plan + legs * instructions_per_leg +
      static_cast<std::int64_t>(instructions_per_m * std::min(length_m, length_max_m));
  const LuaContext& ctx = context(L);
  if (ctx.is_charging && instructions > ctx.instructions_max) {
    throw std::runtime_error(
        fmt::format("rover:plan_path: a route of {:.0f} km is more than one call may plan; plan it "
                    "in parts, each "
                    "in a call of its own",
                    std::min(length_m, length_max_m) / 1000));
  }
  charge(L, instructions);
}

int plan_path(lua_State* L) {
  RoverPort& rover = rover_of(L);
  lua_settop(L, 3);
  const Path3 waypoints = read_path(L, 2, "rover:plan_path");
  const RouteOptions options = check_route_options(L, 3, "rover:plan_path");
  if (options.first > static_cast<std::int64_t>(waypoints.size())) {
    throw std::runtime_error(fmt::format("rover:plan_path: first = {}, there are {} waypoints",
                                         options.first, waypoints.size()));
  }
  charge_planning(L, waypoints, options.first, rover.view().p_S_m);
  const PlannedRoute way = [&] {
    const EngineWork work(L);
    return rover.plan_path(waypoints, options.first, options.settings);
  }();
  if (way.is_found()) {
    push_route(L, way);
    return 1;
  }
  lua_pushnil(L);
  lua_pushstring(L, way.reason.c_str());
  if (!way.nearest_S_m) return 2;
  push_vec3(L, *way.nearest_S_m);
  return 3;
}

int ahead(lua_State* L) {
  const double distance_m = luaL_checknumber(L, 2);
  if (!std::isfinite(distance_m)) {
    throw std::runtime_error(
        fmt::format("rover:ahead({}): a number of metres is wanted", distance_m));
  }
  charge(L, instructions_per_sample);
  const Vec3 place_S_m = [&] {
    const EngineWork work(L);
    return rover_of(L).ahead_S_m(distance_m);
  }();
  push_vec3(L, place_S_m);
  return 1;
}

int brake(lua_State* L) {
  rover_of(L).brake();
  return 0;
}

int distance_to_m(lua_State* L) {
  lua_pushnumber(L, (check_vec3(L, 2) - view_of(L).p_S_m).norm());
  return 1;
}

int push_place_of(lua_State* L) {
  const std::optional<Vec3> p_S_m = rover_of(L).place_of_S_m(luaL_checkstring(L, 2));
  if (!p_S_m) return 0;
  push_vec3(L, *p_S_m);
  return 1;
}

template <auto member>
int push_sight_of(lua_State* L) {
  const RoverPort& rover = rover_of(L);
  const std::string id = luaL_checkstring(L, 2);
  const std::optional<PairSight> sight = rover.sight_of(id);
  if (!sight && id != "Earth" && !rover.place_of_S_m(id)) {
    throw std::runtime_error(fmt::format("there is no rover or asset '{}'", id));
  }
  if (!sight) return 0;
  lua_pushboolean(L, (*sight).*member);
  return 1;
}

int ground_at(lua_State* L) {
  const auto p_S_m = to_vec3(L, 2);
  if (!p_S_m) luaL_typeerror(L, 2, "vec3");
  charge(L, instructions_per_sample);
  const auto ground = [&] {
    const EngineWork work(L);
    return rover_of(L).ground_at(*p_S_m);
  }();
  if (!ground) {
    lua_pushnil(L);
    return 1;
  }
  lua_createtable(L, 0, 4);
  push_vec3(L, ground->p_S_m);
  lua_setfield(L, -2, "position");
  lua_pushnumber(L, ground->elevation_m);
  lua_setfield(L, -2, "elevation_m");
  lua_pushnumber(L, ground->slope_rad);
  lua_setfield(L, -2, "slope_rad");
  lua_pushstring(L, ground->soil.c_str());
  lua_setfield(L, -2, "soil");
  return 1;
}

int sky(lua_State* L) {
  charge(L, instructions_per_sample);
  const SkyView sky = [&] {
    const EngineWork work(L);
    return rover_of(L).sky();
  }();
  lua_createtable(L, 0, 4);
  for (const auto& [name, angle_rad] : {std::pair{"sun_azimuth_rad", sky.sun_azimuth_rad},
                                        {"sun_elevation_rad", sky.sun_elevation_rad},
                                        {"earth_azimuth_rad", sky.earth_azimuth_rad},
                                        {"earth_elevation_rad", sky.earth_elevation_rad}}) {
    push_quantity(L, angle_rad);
    lua_setfield(L, -2, name);
  }
  return 1;
}

}  // namespace

const HandleType& rover_handle_type() {
  using V = RoverView;
  static const HandleType type{
      "rover",
      "The rover that the event belongs to, as it was at the last exchange. A quantity that is not "
      "modelled is nil.",
      {{"id", push_member_text<&V::id>, "text", "RoverId of the plan."},
       {"type", push_member_text<&V::type>, "text", "RoverType of the plan."},
       {"position", position, "vec3", "Reference point, site frame (east, north, up), m."},
       {"lon_rad", quantity<&V::lon_rad>, "number", "Longitude, east positive."},
       {"lat_rad", quantity<&V::lat_rad>, "number", "Latitude."},
       {"elevation_m", quantity<&V::elevation_m>, "number", "Of the ground under it."},
       {"heading_rad", quantity<&V::heading_rad>, "number", "Clockwise from true north."},
       {"pitch_rad", quantity<&V::pitch_rad>, "number", "Nose up positive."},
       {"roll_rad", quantity<&V::roll_rad>, "number", "Right side down positive."},
       {"speed_mps", quantity<&V::speed_mps>, "number", "Along the ground."},
       {"distance_m", quantity<&V::distance_m>, "number", "Driven since the mission's start."},
       {"slope_rad", quantity<&V::slope_rad>, "number", "Of the ground under the wheels."},
       {"slip", quantity<&V::slip>, "number", "Mean over driven wheels; nil when standing."},
       {"sinkage_m", quantity<&V::sinkage_m>, "number", "Mean over wheels."},
       {"drive_w", quantity<&V::drive_w>, "number", "Electrical power of the motors."},
       {"drive_j", quantity<&V::drive_j>, "number", "Its integral since the mission's start."},
       {"cruise_speed_mps", quantity<&V::cruise_speed_mps>, "number", "The type's usual speed."},
       {"length_m", quantity<&V::length_m>, "number", "Of the ground that it covers, ahead."},
       {"turning_radius_m", quantity<&V::turning_radius_m>, "number",
        "The least; 0: it turns on the spot."},
       {"slope_max_rad", slope_max, "number",
        "Steepest slope that its routes are planned over; nil without a limit."},
       {"is_parked", is_parked, "boolean", "Brakes on and standing still."},
       {"is_adjusting", is_adjusting, "boolean", "Its limbs move although it stands."},
       {"clearance_m", quantity<&V::clearance_m>, "number",
        "Under its chassis, mean over its wheels; nil when it is not on limbs."},
       {"stance_fault", stance_fault, "text",
        "Why its limbs, which no longer move, are not in their stance; nil when they are."},
       {"drive", drive, "rover.drive", "What became of its last drive."},
       {"battery", battery, "rover.battery", "Its energy; nil when the rover has no battery."},
       {"panels", panels, "rover.panels", "Its solar panels."},
       {"antennas", antennas, "rover.antennas", "Its antennas."}},
      {{"follow", guard<command_follow>,
        "rover:follow(path, { speed_mps = , arrival_radius_m = , crab = , stray_max_m = , ... })",
        "Drives along waypoints (list of vec3, or one); then answer lsos.arrival. With "
        "`keeps_room_to_turn` it ends so early before a rover that stands that it can still turn "
        "on the spot; on a slope steeper than `slope_max_rad` it warns, once. A path that "
        "begins at the rover may name, in its own field `gear_changes`, the points at which it "
        "changes between forwards and backwards (1: it begins backwards), as that of "
        "rover:plan_path does; crabbing ignores it.",
        "fun(self: lsos.rover, path: vec3|vec3[], settings?: { speed_mps?: number, "
        "arrival_radius_m?: number, crab?: boolean, stray_max_m?: number, keeps_room_to_turn?: "
        "boolean, slope_max_rad?: number })"},
       {"follow_rover", guard<command_follow_rover>,
        "rover:follow_rover(id, { distance_m = , speed_mps = })",
        "Drives behind another rover along its track, at that distance (default 20), at most so "
        "fast (default as fast as its type can), until all events of that one have ended; then "
        "answer lsos.arrival. It enters the track where that is nearest, and stands while the "
        "other one does.",
        "fun(self: lsos.rover, id: string, settings?: { distance_m?: number, speed_mps?: number "
        "})"},
       {"plan_path", guard<plan_path>,
        "rover:plan_path(waypoints, { speed_mps = , slope_max_rad = , aim = , ... })",
        "A route over the ground through the waypoints from number `first` (default 1) on, with "
        "the "
        "least 'energy' (default) or 'risk', its aim; `arrival_radius_m` passes a first waypoint; "
        "`avoid` (list of vec3) and `avoid_radius_m` keep it off places; it goes round the rovers "
        "in `around` (list of RoverIds) where they are now. Gives { path = , legs = , "
        "length_m = , duration_s = , energy_j = , slope_max_rad = }, a leg with `waypoint` and "
        "`last_point` besides; or nil, why there is none, and the place nearest to the waypoint "
        "that can be reached (nil where none was looked for, as of a leg that is too long to "
        "plan).",
        "fun(self: lsos.rover, waypoints: vec3[], settings?: { first?: integer, speed_mps?: "
        "number, slope_max_rad?: number, aim?: 'energy'|'risk', arrival_radius_m?: number, avoid?: "
        "vec3[], avoid_radius_m?: number, around?: string[] }): table?, string?, vec3?"},
       {"ahead", guard<ahead>, "rover:ahead(distance_m)",
        "The place so far ahead of the rover, on the ground.",
        "fun(self: lsos.rover, distance_m: number): vec3"},
       {"ground_at", guard<ground_at>, "rover:ground_at(point)",
        "The ground under or over it: { position = , elevation_m = , slope_rad = , soil = }; nil "
        "where there is none.",
        "fun(self: lsos.rover, point: vec3): { position: vec3, elevation_m: number, slope_rad: "
        "number, soil: string }?"},
       {"sky", guard<sky>, "rover:sky()",
        "Where Sun and Earth stand: { sun_azimuth_rad = , sun_elevation_rad = , earth_azimuth_rad "
        "= , earth_elevation_rad = }; Earth's nil on Earth.",
        "fun(self: lsos.rover): { sun_azimuth_rad: number, sun_elevation_rad: number, "
        "earth_azimuth_rad: number?, earth_elevation_rad: number? }"},
       {"brake", guard<brake>, "rover:brake()", "Stops and holds.", "fun(self: lsos.rover)"},
       {"set_posture", guard<set_posture>,
        "rover:set_posture { stance = , height_m = , level = , duration_s = }",
        "Begins to move its limbs into another stance, as fast as their joints turn or in "
        "`duration_s`; gives the time that it takes. Fails the event where a joint cannot.",
        "fun(self: lsos.rover, posture: { stance?: string, height_m?: number, level?: boolean, "
        "duration_s?: number }): number"},
       {"break_part", guard<break_part>,
        "rover:break_part { what = , part = , mode = , share = , is_repair = }",
        "Something of it breaks, or is repaired, from now on, as Fault says; logged as `fault`.",
        "fun(self: lsos.rover, breakage: { what: string, part?: string, mode?: string, share?: "
        "number, is_repair?: boolean })"},
       {"work", guard<work>, "rover:work(power_w)", "Power that the event uses until it ends.",
        "fun(self: lsos.rover, power_w: number)"},
       {"resource", guard<left_of_resource>, "rover:resource(name)",
        "What is left of it; nil when the rover carries none.",
        "fun(self: lsos.rover, name: string): number?"},
       {"use", guard<use_resource>, "rover:use(name, amount)",
        "Takes it; false, and nothing is taken, when there is not so much.",
        "fun(self: lsos.rover, name: string, amount: number): boolean"},
       {"restock", guard<restock>, "rover:restock(name, amount)",
        "Adds it, up to what there was at the start, or all that is missing without an amount; "
        "gives how much was added.",
        "fun(self: lsos.rover, name: string, amount?: number): number"},
       {"place_of", guard<push_place_of>, "rover:place_of(id)",
        "Position of another rover or an asset; nil when there is none with that id.",
        "fun(self: lsos.rover, id: string): vec3?"},
       {"sees", guard<push_sight_of<&PairSight::is_visible>>, "rover:sees(id)",
        "Whether its antenna saw that of another rover, of an asset, or 'Earth', when they were "
        "last looked at; nil before.",
        "fun(self: lsos.rover, id: string): boolean?"},
       {"is_linked_to", guard<push_sight_of<&PairSight::is_linked>>, "rover:is_linked_to(id)",
        "The same, within range and with both antennas up.",
        "fun(self: lsos.rover, id: string): boolean?"},
       {"distance_to_m", guard<distance_to_m>, "rover:distance_to_m(point)",
        "Straight distance from the reference point.",
        "fun(self: lsos.rover, point: vec3): number"}}};
  return type;
}

}  // namespace lsos
