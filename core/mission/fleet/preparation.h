// What is done with a fleet before the mission starts: rovers are placed, and routes planned.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mission/ahead/route_ahead.h"
#include "mission/fleet/fleet.h"
#include "mission/fleet/mission_site.h"

namespace lsos {

// The routes of one rover that are planned before the start.
struct RoverRoutesAhead {
  std::string rover_id;
  std::vector<LegAhead> legs;
  std::vector<PassedWaypoint> passed;
  std::vector<DrawnLine> drawn;
};

struct FleetRoutes {
  std::vector<RoverRoutesAhead> rovers;  // one for each rover; empty: none were planned
  std::vector<Fault> faults;             // errors and warnings
};

// Places the rovers at their starts; those in `starts` begin as that says. Returns what is wrong
// there and at their events' places, but for rovers that stand in each other.
Faults place_rovers(Fleet& fleet, const MissionMachine& machine, const Ground& ground,
                    ScriptHost& host, const std::map<std::string, RoverStart>& starts);

// Plans the routes of all events that want one. Warnings include those about equipment that events
// need.
FleetRoutes plan_routes(Fleet& fleet, const MissionMachine& machine, const MissionSite& site,
                        const SimulationSetup& setup, ScriptHost& host);

}  // namespace lsos
