// Parameters and waypoints of events between Lua and C++.
#pragma once

#include <lua.hpp>

#include "mission/port/script_host.h"

namespace lsos {

// Pushes ev.params, a read-only view of the arguments. An absent optional parameter reads as nil;
// an unknown key raises an error that suggests the nearest one. Moments become seconds since the
// mission's start.
void push_params(lua_State* L, const EventDeclaration& event, const EventArguments& arguments,
                 Instant mission_start);

// Reads the table (or nil) at `index` that a script gives to an event it starts: every key, type
// and range is checked and defaults are filled in. Throws std::runtime_error with all faults.
std::map<std::string, FieldValue> read_params(lua_State* L, int index,
                                              const EventDeclaration& event, Instant mission_start);

// Reads a vec3, a list of them or ev.geometry. Throws std::runtime_error naming `what`.
Path3 read_path(lua_State* L, int index, const std::string& what);

// Reads a path or nil into the arguments' geometry. A polygon's holes are read too; a list has them
// under the key `holes`. Throws std::runtime_error when the value is something else, or a geometry
// that the event does not take.
void read_waypoints(lua_State* L, int index, const EventDeclaration& event,
                    EventArguments& arguments);

// The event's phase of that name. Throws std::runtime_error that lists the phases when there is
// none.
const EventDeclaration::Phase& find_phase(const EventDeclaration& event, const std::string& name);

}  // namespace lsos
