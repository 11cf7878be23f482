// Planned ways between Lua and C++.
#pragma once

#include <lua.hpp>

#include "lua/runtime/reader.h"
#include "mission/port/rover_port.h"

namespace lsos {

// What rover:plan_path is told, and what an event's `route` gives.
struct RouteOptions {
  RouteSettings settings;
  std::int64_t first = 1;  // waypoint that comes next
};

void read_route_options(TableReader& t, RouteOptions& options);

// Reads the table (or nil: all as it is) at `index`. Throws InputError with all faults.
RouteOptions check_route_options(lua_State* L, int index, const char* what);

// Pushes { path = , legs = , length_m = , ... }.
void push_way(lua_State* L, const PlannedWay& way);

}  // namespace lsos
