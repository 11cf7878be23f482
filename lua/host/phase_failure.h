// What is said of an event's script that broke.
#pragma once

#include "lua/host/event_library.h"
#include "lua/runtime/state.h"
#include "mission/port/script_host.h"

namespace lsos {

// events/Route.lua:23: Route 'leg 2' in phase drive at 812.4 s: attempt to ...
//   plan.kml:41: rover A at 25.0042 E, 89.4005 S (12.0, 40.1 m from the site), heading 12 deg, ...
// and the traceback. `where`: "phase drive".
std::string phase_failure(const LuaFailure& failure, const EventScript& script,
                          const std::string& where, const PhaseContext& context);

// "heading 12.0 deg, 1.40 m/s, ...": what a rover does, for a message.
std::string state_text(RoverPort& rover);

}  // namespace lsos
