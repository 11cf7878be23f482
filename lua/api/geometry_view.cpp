// `ev.geometry`: the waypoints of an event, and the methods for polygons.
#include <fmt/format.h>

#include <string>

#include "lua/runtime/handle.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"
#include "lua/runtime/vec3.h"
#include "route/map/free_area.h"

namespace lsos {

namespace {

constexpr const char* geometry_metatable = "lsos.geometry";

const EventArguments& arguments_of(lua_State* L) {
  luaL_checkudata(L, 1, geometry_metatable);
  return *to_geometry(L, 1);
}

void push_path(lua_State* L, const Path3& path) {
  lua_createtable(L, static_cast<int>(path.size()), 0);
  for (std::size_t i = 0; i < path.size(); ++i) {
    push_vec3(L, path[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
}

int holes(lua_State* L) {
  constexpr std::int64_t instructions_per_corner = 20;
  const std::vector<Path3>& holes_S_m = arguments_of(L).holes_S_m;
  lua_createtable(L, static_cast<int>(holes_S_m.size()), 0);
  for (std::size_t i = 0; i < holes_S_m.size(); ++i) {
    charge(L, instructions_per_corner * static_cast<std::int64_t>(holes_S_m[i].size()));
    push_path(L, holes_S_m[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  return 1;
}

Ring ring_of(const Path3& corners) {
  Ring ring;
  for (const Vec3& corner : corners) ring.emplace_back(corner.head<2>());
  return ring;
}

FreeArea area_of(lua_State* L, const char* method) {
  const EventArguments& arguments = arguments_of(L);
  if (arguments.geometry_S_m.size() < 3) {
    throw std::runtime_error(
        fmt::format("ev.geometry:{} is for polygons; this one has {} waypoints", method,
                    arguments.geometry_S_m.size()));
  }
  std::vector<Ring> holes;
  for (const Path3& hole : arguments.holes_S_m) holes.push_back(ring_of(hole));
  return {ring_of(arguments.geometry_S_m), std::move(holes)};
}

// Arguments 2 to 4 of `parts` and `path`: from, to and the margin.
struct Request {
  Vec2 from_m, to_m;
  double margin_m = 0;
};

Request check_request(lua_State* L, const char* method) {
  const Vec3 from_S_m = check_vec3(L, 2), to_S_m = check_vec3(L, 3);
  const double margin_m = luaL_optnumber(L, 4, 0);
  if (!(margin_m >= 0 && margin_m <= 1e6)) {
    throw std::runtime_error(
        fmt::format("ev.geometry:{}: a margin of {}; 0 m or more is wanted", method, margin_m));
  }
  return {from_S_m.head<2>(), to_S_m.head<2>(), margin_m};
}

int parts(lua_State* L) {
  constexpr std::int64_t instructions_per_side = 5;
  const Request request = check_request(L, "parts");
  const FreeArea area = area_of(L, "parts");
  charge(L, instructions_per_side * static_cast<std::int64_t>(area.size()));
  lua_newtable(L);
  if (request.from_m == request.to_m) return 1;
  lua_Integer count = 0;
  const auto push_at = [&](double share) {
    const Vec2 at_m = request.from_m + share * (request.to_m - request.from_m);
    push_vec3(L, {at_m.x(), at_m.y(), 0});
  };
  for (const auto& [from, to] : area.parts(request.from_m, request.to_m, request.margin_m)) {
    lua_createtable(L, 2, 0);
    push_at(from);
    lua_rawseti(L, -2, 1);
    push_at(to);
    lua_rawseti(L, -2, 2);
    lua_rawseti(L, -2, ++count);
  }
  return 1;
}

int path(lua_State* L) {
  // A path between few corners costs a fraction of this; one between thousands takes up to some
  // seconds.
  constexpr std::int64_t instructions_per_path = 200, instructions_per_side = 200;
  const Request request = check_request(L, "path");
  const FreeArea area = area_of(L, "path");
  const bool has_holes = !arguments_of(L).holes_S_m.empty();
  charge(L, instructions_per_path + instructions_per_side * static_cast<std::int64_t>(area.size()));
  const auto found = [&] {
    const EngineWork work(L);
    return area.path(request.from_m, request.to_m, request.margin_m);
  }();
  if (!found || found->is_given_up) {
    lua_pushnil(L);
    const std::string why =
        found ? fmt::format("the polygon has too many corners ({}) to find paths in; simplify it",
                            area.size())
              : fmt::format("there is no path within the polygon{}",
                            has_holes ? ", round its holes" : "");
    lua_pushlstring(L, why.data(), why.size());
    return 2;
  }
  Path3 points_S_m;
  for (const Vec2& point_m : found->points_m) {
    points_S_m.emplace_back(point_m.x(), point_m.y(), 0);
  }
  push_path(L, points_S_m);
  lua_pushnumber(L, found->margin_m);
  return 2;
}

// Pushes a new vec3 each time, so that changing it changes nothing here.
int geometry_index(lua_State* L) {
  const Path3& points_S_m = arguments_of(L).geometry_S_m;
  if (lua_type(L, 2) == LUA_TSTRING) {
    const std::string key = key_text(L, 2);
    for (const HandleField& field : geometry_type().fields) {
      if (key == field.name) return field.read(L);
    }
    for (const HandleMethod& method : geometry_type().methods) {
      if (key != method.name) continue;
      lua_pushcfunction(L, method.function);
      return 1;
    }
  }
  int is_whole = 0;
  const lua_Integer i = lua_tointegerx(L, 2, &is_whole);
  if (lua_type(L, 2) != LUA_TNUMBER || is_whole == 0) {
    throw std::runtime_error(
        "ev.geometry is a list: ev.geometry[1] is the first waypoint; beside that it has holes, "
        "parts and path");
  }
  if (i < 1 || static_cast<std::size_t>(i) > points_S_m.size()) {
    lua_pushnil(L);
  } else {
    push_vec3(L, points_S_m[static_cast<std::size_t>(i - 1)]);
  }
  return 1;
}

int geometry_length(lua_State* L) {
  lua_pushinteger(L, static_cast<lua_Integer>(arguments_of(L).geometry_S_m.size()));
  return 1;
}

int geometry_write(lua_State*) { throw std::runtime_error("ev.geometry is read-only"); }

int geometry_pairs(lua_State*) { throw std::runtime_error("ev.geometry is a list: use ipairs"); }

}  // namespace

const EventArguments* to_geometry(lua_State* L, int index) {
  const auto* id = static_cast<const ScriptInstance*>(luaL_testudata(L, index, geometry_metatable));
  if (id == nullptr) return nullptr;
  const EventCall& call = running_call(L, "ev.geometry");
  if (call.instance != *id) {
    throw std::runtime_error("ev.geometry belongs to an event that is not running now");
  }
  return &call.arguments;
}

void push_geometry(lua_State* L, ScriptInstance instance) {
  auto* id = static_cast<ScriptInstance*>(lua_newuserdatauv(L, sizeof(ScriptInstance), 0));
  *id = instance;
  if (luaL_newmetatable(L, geometry_metatable) != 0) {
    constexpr luaL_Reg functions[] = {{"__index", guard<geometry_index>},
                                      {"__len", guard<geometry_length>},
                                      {"__newindex", guard<geometry_write>},
                                      {"__pairs", guard<geometry_pairs>},
                                      {nullptr, nullptr}};
    luaL_setfuncs(L, functions, 0);
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
  }
  lua_setmetatable(L, -2);
}

const HandleType& geometry_type() {
  static const HandleType type{
      "ev.geometry",
      "A list of vec3: `#ev.geometry`, `ev.geometry[1]`, `ipairs(ev.geometry)`. Of a polygon it is "
      "the outline, and there are holes in it:",
      {{"holes", holes, "list of rings",
        "Holes of a polygon (innerBoundaryIs), each a list of vec3; empty without."}},
      {{"parts", guard<parts>, "ev.geometry:parts(from, to, margin_m)",
        "Where the straight line between two places lies inside the polygon's outline and at least "
        "so far (default 0 m) from its holes: a list of { from, to }.",
        "fun(self: lsos.ev.geometry, from: vec3, to: vec3, margin_m?: number): vec3[][]"},
       {"path", guard<path>, "ev.geometry:path(from, to, margin_m)",
        "The shortest path that stays inside the outline and so far from the holes, as waypoints "
        "after `from`, and the margin that it keeps: half of what was wanted, or less, where there "
        "is no room for more. nil, and why, when none is found.",
        "fun(self: lsos.ev.geometry, from: vec3, to: vec3, margin_m?: number): vec3[]?, "
        "number|string"}},
      nullptr,
      "vec3[]"};
  return type;
}

}  // namespace lsos
