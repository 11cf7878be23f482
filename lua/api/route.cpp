#include "lua/api/route.h"

#include <fmt/format.h>

#include "lua/api/arguments.h"
#include "lua/runtime/vec3.h"

namespace lsos {

namespace {

constexpr double right_angle_rad = 1.5707963267948966;

void push_field(lua_State* L, const char* key, double value) {
  lua_pushnumber(L, value);
  lua_setfield(L, -2, key);
}

void push_field(lua_State* L, const char* key, std::int64_t value) {
  lua_pushinteger(L, value);
  lua_setfield(L, -2, key);
}

void push_leg(lua_State* L, const PlannedRoute::Leg& leg) {
  lua_createtable(L, 0, 6);
  push_field(L, "waypoint", leg.waypoint);
  push_field(L, "last_point", static_cast<std::int64_t>(leg.last_point) + 1);
  push_field(L, "length_m", leg.length_m);
  push_field(L, "duration_s", leg.duration_s);
  push_field(L, "energy_j", leg.energy_j);
  push_field(L, "slope_max_rad", leg.slope_max_rad);
}

// Sets gear_changes of the path on top of the stack.
void push_gear_changes(lua_State* L, const std::vector<std::size_t>& points) {
  if (points.empty()) return;
  lua_createtable(L, static_cast<int>(points.size()), 0);
  lua_Integer number = 0;
  for (const std::size_t point : points) {
    lua_pushinteger(L, static_cast<lua_Integer>(point) + 1);
    lua_rawseti(L, -2, ++number);
  }
  lua_setfield(L, -2, "gear_changes");
}

// Reads avoid = list of vec3, avoid_radius_m = number.
void read_avoided(TableReader& t, std::vector<AvoidedDisc>& avoided) {
  Path3 places;
  if (t.take(optional, "avoid", "list of vec3", "Places to keep off, whatever the ground there.")) {
    if (!lua_isnil(t.L(), -1)) places = read_path(t.L(), -1, t.what() + ": avoid");
    lua_pop(t.L(), 1);
  }
  double radius_m = 0;
  t.number(optional, "avoid_radius_m", radius_m, positive,
           "How far the rover's reference point keeps off them.");
  if (!places.empty() && !(radius_m > 0)) t.fault("avoid wants avoid_radius_m besides");
  for (const Vec3& place_S_m : places) avoided.push_back({place_S_m, radius_m});
}

}  // namespace

void read_route_options(TableReader& t, RouteOptions& options) {
  RouteSettings& settings = options.settings;
  t.number(optional, "speed_mps", settings.speed_mps, positive,
           "Driving speed (default: the rover's cruise speed).");
  t.number(optional, "slope_max_rad", settings.slope_max_rad, {0, right_angle_rad, true},
           "Steepest slope, besides the rover's own limit.");
  constexpr std::pair<const char*, RouteAim> aims[] = {{"energy", RouteAim::energy},
                                                       {"risk", RouteAim::risk}};
  t.word(optional, "aim", aims, settings.aim,
         "What the way makes least: the 'energy' of driving, or 'risk', the metres weighed by how "
         "near each comes to a limit (default 'energy').");
  t.number(optional, "arrival_radius_m", settings.arrival_radius_m, positive,
           "A first waypoint that is this near, and no more than 1 m away, is passed (default 1).");
  read_avoided(t, settings.avoided);
  t.texts(optional, "around", settings.around,
          "RoverIds of rovers that it goes round where they are now.");
  t.integer(optional, "first", options.first, Range{1}, "The waypoint to begin with (default 1).");
}

RouteOptions check_route_options(lua_State* L, int index, const char* what) {
  RouteOptions options;
  if (lua_isnoneornil(L, index)) return options;
  if (!lua_istable(L, index)) {
    throw std::runtime_error(
        fmt::format("{}: a table is wanted, found {}", what, describe(L, index)));
  }
  Faults faults;
  TableReader t(L, lua_absindex(L, index), what, {}, faults);
  read_route_options(t, options);
  t.finish();
  faults.throw_if_errors();
  return options;
}

std::vector<std::size_t> read_gear_changes(lua_State* L, int index, std::size_t point_count,
                                           const std::string& what) {
  index = lua_absindex(L, index);
  std::vector<std::size_t> points;
  if (!lua_istable(L, index) || is_vec3(L, index)) return points;
  lua_pushliteral(L, "gear_changes");
  const int type = lua_rawget(L, index);
  const lua_Integer count = type == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(L, -1)) : 0;
  bool is_list = type == LUA_TTABLE || type == LUA_TNIL;
  for (lua_Integer i = 1; is_list && i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    const lua_Integer point = lua_isinteger(L, -1) ? lua_tointeger(L, -1) : 0;
    const lua_Integer least = points.empty() ? 1 : static_cast<lua_Integer>(points.back()) + 2;
    is_list = point >= least && point < static_cast<lua_Integer>(point_count);
    if (is_list) points.push_back(static_cast<std::size_t>(point) - 1);
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  if (is_list) return points;
  throw std::runtime_error(fmt::format(
      "{}: gear_changes of the path must be a list of its points, integers from 1 to {}, ascending",
      what, point_count - 1));
}

void push_route(lua_State* L, const PlannedRoute& way) {
  lua_createtable(L, 0, 6);
  lua_createtable(L, static_cast<int>(way.path_S_m.size()), 0);
  lua_Integer number = 0;
  for (const Vec3& p_S_m : way.path_S_m) {
    push_vec3(L, p_S_m);
    lua_rawseti(L, -2, ++number);
  }
  push_gear_changes(L, way.gear_changes);
  lua_setfield(L, -2, "path");
  PlannedRoute::Leg sum;
  lua_createtable(L, static_cast<int>(way.legs.size()), 0);
  number = 0;
  for (const PlannedRoute::Leg& leg : way.legs) {
    push_leg(L, leg);
    lua_rawseti(L, -2, ++number);
    sum.length_m += leg.length_m;
    sum.duration_s += leg.duration_s;
    sum.energy_j += leg.energy_j;
    sum.slope_max_rad = std::max(sum.slope_max_rad, leg.slope_max_rad);
  }
  lua_setfield(L, -2, "legs");
  push_field(L, "length_m", sum.length_m);
  push_field(L, "duration_s", sum.duration_s);
  push_field(L, "energy_j", sum.energy_j);
  push_field(L, "slope_max_rad", sum.slope_max_rad);
}

}  // namespace lsos
