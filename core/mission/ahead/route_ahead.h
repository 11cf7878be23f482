// Goes through a rover's events before the mission starts, as far as its position is known: plans
// routes, and finds obstacles on lines that are driven as drawn.
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

// Lengths of a line that an event drives as drawn: straight from the expected position of the rover
// to the first waypoint, and on through the others.
struct DrawnLine {
  std::int64_t sequence = 0;
  std::optional<double> to_first_m;  // absent: the rover's position is not known
  double along_m = 0;
};

struct RouteAhead {
  std::vector<LegAhead> legs;
  std::vector<PassedWaypoint> passed;
  std::vector<DrawnLine> drawn;
  // Legs without a route, as foreseen_failure(). Warnings about what lies on legs driven as drawn,
  // waypoints inside the turning circle, areas without ground, speeds that the rover does not
  // reach, and assets beyond the cable.
  std::vector<Fault> faults;
};

// What a rover's events ask of their routes, in their order; absent where an event plans none. Adds
// what goes wrong in their scripts to `faults`.
using AskedRoutes = std::vector<std::optional<RouteSettings>>;
AskedRoutes asked_routes(const RoverMachine& machine, const MissionInfo& mission, ScriptHost& host,
                         std::vector<Fault>& faults);

// Each event begins where those before it leave the rover. `asked`: asked_routes() of the rover.
// `sources`: assets with power to give. `on_planning` may be empty; it is called with what is being
// planned, and with "" when that ends. Rovers may be planned for at the same time by several
// threads.
RouteAhead plan_ahead(const RoverMachine& machine, const AskedRoutes& asked,
                      double start_heading_rad, const Ground& ground, RoverRoutes& routes,
                      std::span<const PowerSource> sources,
                      const std::function<void(const std::string& what)>& on_planning);

}  // namespace lsos
