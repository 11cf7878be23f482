// Planned routes between Lua and C++.
#pragma once

#include <cstddef>
#include <lua.hpp>
#include <string>
#include <vector>

#include "lua/runtime/reader.h"
#include "mission/port/rover_port.h"

namespace lsos {

// Options of rover:plan_path, and the result of an event's `route`.
struct RouteOptions {
  RouteSettings settings;
  std::int64_t first = 1;  // waypoint that comes next
};

void read_route_options(TableReader& t, RouteOptions& options);

// Reads the table at `index` (nil: all defaults). Throws InputError with all faults.
RouteOptions check_route_options(lua_State* L, int index, const char* what);

// Reads `gear_changes` of a path at `index`, numbers of points from 1 before the last, ascending;
// none where it has no such key. Throws std::runtime_error naming `what`.
std::vector<std::size_t> read_gear_changes(lua_State* L, int index, std::size_t point_count,
                                           const std::string& what);

// Pushes the route as { path = , legs = , length_m = , ... }.
void push_route(lua_State* L, const PlannedRoute& way);

}  // namespace lsos
