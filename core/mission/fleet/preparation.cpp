#include "mission/fleet/preparation.h"

#include "mission/ahead/equipment_warnings.h"
#include "mission/fleet/avoidance.h"
#include "mission/model/site.h"

namespace lsos {

Faults place_rovers(Fleet& fleet, const MissionMachine& machine, const Ground& ground,
                    ScriptHost& host, const std::map<std::string, RoverStart>& starts) {
  Faults faults;
  const auto plans_its_route = [&](const PlanEvent& event) {
    try {
      return host.route_settings(event.type, {event.params, {}}, machine.mission.start_time)
          .has_value();
    } catch (const ScriptError&) {
      return false;  // plan_routes() reports it
    }
  };
  for (std::size_t i = 0; i < fleet.rovers.size(); ++i) {
    try {
      RoverAgent& agent = *fleet.rovers[i].agent;
      const auto start = starts.find(agent.id());
      if (start != starts.end()) {
        agent.begin(start->second);
      } else {
        agent.place(default_heading_rad(machine.rovers[i], ground.site()));
      }
    } catch (const InputError& error) {
      faults.add(error.faults());
    }
    faults.add(site_faults(machine.rovers[i], ground, plans_its_route));
  }
  if (!faults.has_errors()) faults.add(overlapping_rovers(fleet, machine));
  return faults;
}

FleetRoutes plan_routes(Fleet& fleet, const MissionMachine& machine, const MissionSite& site,
                        const SimulationSetup& setup, ScriptHost& host) {
  Faults faults;
  FleetRoutes routes;
  for (std::size_t i = 0; i < fleet.rovers.size(); ++i) {
    RoverAgent& agent = *fleet.rovers[i].agent;
    RouteAhead ahead =
        plan_ahead(machine.rovers[i], machine.mission, agent.view().heading_rad, host, *site.ground,
                   agent.routes(), site.sources, setup.on_planning);
    faults.add(ahead.faults);
    faults.add(
        equipment_warnings(machine.rovers[i], machine.mission, agent, host, site.ground->site()));
    routes.rovers.push_back(
        {agent.id(), std::move(ahead.legs), std::move(ahead.passed), std::move(ahead.drawn)});
  }
  routes.faults = faults.sorted();
  return routes;
}

}  // namespace lsos
