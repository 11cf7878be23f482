// Messages for failed event scripts.
#pragma once

#include "lua/host/event_library.h"
#include "lua/runtime/state.h"
#include "mission/port/script_host.h"

namespace lsos {

// Message for a script that failed in `where` ("phase drive"), with the traceback:
//   events/Route.lua:23: Route 'leg 2' in phase drive at 812.4 s: attempt to ...
//     plan.kml:41: rover A: 12.0 m east, 40.1 m north of the site, heading 12.0 deg, ...
std::string phase_failure(const LuaFailure& failure, const EventScript& script,
                          const std::string& where, const PhaseContext& context);

// State of a rover for a message: "12.0 m east, 40.1 m north of the site, heading 12.0 deg, ...".
std::string state_text(RoverPort& rover);

}  // namespace lsos
