// Planning ways before the mission starts, as far as it is known where each leg will begin.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/error.h"
#include "mission/machine.h"
#include "mission/rover_routes.h"
#include "mission/script_host.h"

namespace lsos {

// A waypoint that the rover stands on when its event starts.
struct PassedWaypoint {
  std::int64_t sequence = 0, waypoint = 0;
};

struct RouteAhead {
  std::vector<LegAhead> legs;
  std::vector<PassedWaypoint> passed;
  // A leg without a way: an error, or a warning where the plan says what then shall happen.
  std::vector<Fault> faults;
};

// The ways of one rover's events that plan theirs, each from where the events before it leave the
// rover. `on_planning` may be empty; it is told what is planned, "" at its end.
RouteAhead plan_ahead(const RoverMachine& machine, const MissionInfo& mission,
                      double start_heading_rad, ScriptHost& host, const Ground& ground,
                      RoverRoutes& routes,
                      const std::function<void(const std::string& what)>& on_planning);

}  // namespace lsos
