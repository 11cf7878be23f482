// Objects of the host that scripts use: `ev`, `rover`, `rover.drive`. A handle holds the id of its
// event and no pointer; it works only while a phase of that event runs. Fields are read-only.
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
  lua_CFunction write = nullptr;  // __newindex; absent: every write is refused
  const char* is_a = "";          // its base class, as the Lua language server writes it
};

const HandleType& event_handle_type();
// Fields and methods of ev.geometry besides its waypoints.
const HandleType& geometry_type();
const HandleType& rover_handle_type();
const HandleType& drive_handle_type();
const HandleType& battery_handle_type();
const HandleType& panels_handle_type();
const HandleType& antennas_handle_type();

// Pushes a handle (with one user value) of an event.
void push_handle(lua_State* L, const HandleType& type, ScriptInstance instance);

// Type of the handle at `index`; nullptr when the value there is no handle.
const HandleType* handle_type(lua_State* L, int index);

// Id of the handle at argument 1. Throws std::runtime_error when it is another object.
ScriptInstance handle_id(lua_State* L, const HandleType& type);

// The rover that the handle at argument 1 belongs to: that of the running event, or one of an
// interactive simulation. Throws as handle_call().
RoverPort& handle_rover(lua_State* L, const HandleType& type);
// The same of a handle of rovers.
inline RoverPort& rover_of(lua_State* L) { return handle_rover(L, rover_handle_type()); }

// The running call that the handle at argument 1 belongs to. Throws std::runtime_error when it is
// another object, or belongs to an event that is not running now.
const EventCall& handle_call(lua_State* L, const HandleType& type);

// Throws "ev has no 'sate'; did you mean 'state'?".
[[noreturn]] void refuse_handle_key(const HandleType& type, const char* key);

// Pushes a number, or nil for NaN, which stands for a quantity that is not modelled.
void push_quantity(lua_State* L, double value);

// Pushes the read-only view of the event's waypoints (geometry_view.cpp).
void push_geometry(lua_State* L, ScriptInstance instance);

// The event's arguments if the value at `index` is ev.geometry, else nullptr. Throws
// std::runtime_error when it belongs to an event that is not running now.
const EventArguments* to_geometry(lua_State* L, int index);

}  // namespace lsos
