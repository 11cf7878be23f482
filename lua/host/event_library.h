// All event scripts, loaded into one Lua state.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "lua/api/api.h"
#include "lua/runtime/file_locals.h"
#include "lua/runtime/script.h"
#include "lua/runtime/state.h"
#include "plan/declaration.h"

namespace lsos {

struct EventScript {
  EventDeclaration declaration;
  std::string file;
  int functions = LUA_NOREF;  // registry reference, see event_constructors.h
  FileLocals locals;
  int number = 0;  // owner of its texts, see ScriptMemory
};

class EventLibrary {
 public:
  explicit EventLibrary(const Limits& limits = {}) : lua_(make_api, limits) {}

  // Loads one script. If it has faults they are collected, and the event does not exist.
  void load(const Script& script, Faults& faults);
  // Forgets the event, if there is one.
  void remove(const std::string& name);
  // Runs C++ code that calls functions of the event.
  void run(const EventScript& event, const std::function<void(lua_State*)>& body);
  // Removes events with a phase that names a missing event, and events that contain themselves.
  void check_sub_events(std::map<std::string, Faults>& faults);

  const std::map<std::string, EventScript>& events() const { return events_; }
  LuaState& lua() { return lua_; }

 private:
  LuaState lua_;
  std::map<std::string, EventScript> events_;
};

}  // namespace lsos
