// Objects of the host in scripts: `ev`, `rover`, `rover.drive`. A handle holds the id of its event,
// no pointer; it answers only while that event's phase runs. Fields are read-only.
#pragma once

#include <lua.hpp>
#include <vector>

#include "lua/runtime/context.h"

namespace lsos {

struct HandleField {
  const char* name;
  lua_CFunction read;  // argument 1 is the handle; pushes the value
  const char* type;
  const char* doc;
};

struct HandleMethod {
  const char* name;
  lua_CFunction function;
  const char* signature;
  const char* doc;
  const char* type;  // as the Lua language server writes it
};

struct HandleType {
  const char* name;  // as scripts call it: "rover"
  const char* doc;
  std::vector<HandleField> fields;
  std::vector<HandleMethod> methods;
  lua_CFunction write = nullptr;  // __newindex; absent: everything is refused
  const char* is_a = "";          // what it is besides, as the Lua language server writes it
};

const HandleType& event_handle_type();
// What ev.geometry has beside its waypoints.
const HandleType& geometry_type();
const HandleType& rover_handle_type();
const HandleType& drive_handle_type();
const HandleType& battery_handle_type();
const HandleType& panels_handle_type();
const HandleType& antennas_handle_type();

// Pushes a handle (with one user value) of an event.
void push_handle(lua_State* L, const HandleType& type, ScriptInstance instance);

// Of a handle; nullptr when the value at `index` is none.
const HandleType* handle_type(lua_State* L, int index);

// Its id. Throws std::runtime_error when argument 1 is another object.
ScriptInstance handle_id(lua_State* L, const HandleType& type);

// The rover that the handle at argument 1 belongs to: of the running event, or one in hand. Throws
// as handle_call().
RoverPort& handle_rover(lua_State* L, const HandleType& type);

// The call that the handle at argument 1 belongs to. Throws std::runtime_error when it is another
// object, or one of an event that is not running now.
const EventCall& handle_call(lua_State* L, const HandleType& type);

// Throws "ev has no 'sate'; did you mean 'state'?".
[[noreturn]] void refuse_handle_key(const HandleType& type, const char* key);

// NaN, a quantity that is not modelled, is nil for scripts.
void push_quantity(lua_State* L, double value);

// The read-only view of the event's waypoints (geometry_view.cpp).
void push_geometry(lua_State* L, ScriptInstance instance);

// The event's arguments if the value at `index` is that view, else nullptr. Throws
// std::runtime_error when it belongs to an event that is not running now.
const EventArguments* to_geometry(lua_State* L, int index);

}  // namespace lsos
