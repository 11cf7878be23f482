// Going through a rover's events before the mission starts, as far as it is known where it will be:
// ways are planned, and what stands in the way of others is found.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "mission/model/machine.h"
#include "mission/port/script_host.h"
#include "mission/routes/rover_routes.h"
#include "mission/rover/rover_power.h"

namespace lsos {

// A waypoint that the rover stands on when its event starts.
struct PassedWaypoint {
  std::int64_t sequence = 0, waypoint = 0;
};

// What an event drives as it is drawn: from where the rover is expected to its first waypoint, and
// through the others; straight lines.
struct DrawnLine {
  std::int64_t sequence = 0;
  std::optional<double> to_first_m;  // absent: nobody knows where the rover then is
  double along_m = 0;
};

struct RouteAhead {
  std::vector<LegAhead> legs;
  std::vector<PassedWaypoint> passed;
  std::vector<DrawnLine> drawn;
  // A leg without a way, as foreseen_failure(). Warnings of what lies on legs that are driven as
  // drawn, of waypoints inside the turning circle, of speeds that the rover does not reach, and of
  // assets beyond the cable.
  std::vector<Fault> faults;
};

// Each event begins where those before it leave the rover. `sources`: assets with power to give.
// `on_planning` may be empty; it is told what is planned, "" at its end.
RouteAhead plan_ahead(const RoverMachine& machine, const MissionInfo& mission,
                      double start_heading_rad, ScriptHost& host, const Ground& ground,
                      RoverRoutes& routes, std::span<const PowerSource> sources,
                      const std::function<void(const std::string& what)>& on_planning);

}  // namespace lsos
