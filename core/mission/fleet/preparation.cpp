#include "mission/fleet/preparation.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "base/worker_pool.h"
#include "mission/ahead/equipment_warnings.h"
#include "mission/fleet/avoidance.h"
#include "mission/model/site.h"

namespace lsos {

namespace {

// Reports, of what is planned for several rovers at the same time, what began first.
class OldestPlanned {
 public:
  using Report = std::function<void(const std::string& what)>;

  OldestPlanned(std::size_t rovers, const Report& report) : planned_(rovers), report_(report) {}

  // `what` is planned for a rover from now on; "": nothing.
  void set(std::size_t rover, const std::string& what) {
    if (!report_) return;
    const std::lock_guard lock(mutex_);
    planned_[rover] = {++calls_, what};
    const Planned* oldest = nullptr;
    for (const Planned& planned : planned_) {
      if (planned.what.empty()) continue;
      if (oldest == nullptr || planned.began < oldest->began) oldest = &planned;
    }
    std::string now = oldest == nullptr ? "" : oldest->what;
    if (now != reported_) report_(now);
    reported_ = std::move(now);
  }

 private:
  struct Planned {
    long long began = 0;
    std::string what;
  };
  std::mutex mutex_;
  std::vector<Planned> planned_;
  const Report& report_;
  std::string reported_;
  long long calls_ = 0;
};

}  // namespace

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
  return faults;
}

FleetRoutes plan_routes(Fleet& fleet, const MissionMachine& machine, const MissionSite& site,
                        const SimulationSetup& setup, ScriptHost& host) {
  const std::size_t count = fleet.rovers.size();
  std::vector<Fault> asking;
  std::vector<AskedRoutes> asked;
  for (const RoverMachine& rover : machine.rovers) {
    asked.push_back(asked_routes(rover, machine.mission, host, asking));
  }
  std::vector<RouteAhead> ahead(count);
  OldestPlanned report(count, setup.on_planning);
  WorkerPool(std::clamp(setup.threads, 1, std::max(1, static_cast<int>(count))))
      .for_each(count, [&](std::size_t i) {
        RoverAgent& agent = *fleet.rovers[i].agent;
        ahead[i] = plan_ahead(machine.rovers[i], asked[i], agent.view().heading_rad, *site.ground,
                              agent.routes(), site.sources,
                              [&](const std::string& what) { report.set(i, what); });
      });
  Faults faults;
  faults.add(asking);
  FleetRoutes routes;
  for (std::size_t i = 0; i < count; ++i) {
    RoverAgent& agent = *fleet.rovers[i].agent;
    faults.add(ahead[i].faults);
    faults.add(
        equipment_warnings(machine.rovers[i], machine.mission, agent, host, site.ground->site()));
    routes.rovers.push_back({agent.id(), std::move(ahead[i].legs), std::move(ahead[i].passed),
                             std::move(ahead[i].drawn)});
  }
  routes.faults = faults.sorted();
  return routes;
}

}  // namespace lsos
