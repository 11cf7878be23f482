// How far a simulation has come.
#include <algorithm>

#include "mission/simulation.h"

namespace lsos {

double Simulation::progress() const {
  auto ended = static_cast<double>(fleet_.events_ended());
  for (const FleetRover& rover : fleet_.rovers) ended += rover.agent->drive().share();
  const auto events = static_cast<double>(setup_.plan.events.size());
  return events > 0 ? std::min(1.0, ended / events) : 1;
}

MissionWork Simulation::work() const {
  MissionWork work;
  for (std::size_t k = 0; k < fleet_.rovers.size(); ++k) {
    const FleetRover& rover = fleet_.rovers[k];
    const RoverMachine& machine = machine_.rovers[k];
    add_work({machine.rover, rover.sequence.events()}, rover.sequence.records(),
             setup_.rover_models.at(machine.rover.model()), machine_.mission, now_,
             rover.agent->drive().share(), rover.sequence.is_finished(), work);
  }
  return work;
}

bool Simulation::is_at_rest() const {
  return std::ranges::all_of(fleet_.rovers,
                             [](const FleetRover& rover) { return rover.agent->is_parked(); });
}

std::vector<std::string> Simulation::moving_rovers() const {
  std::vector<std::string> ids;
  for (const FleetRover& rover : fleet_.rovers) {
    if (!rover.agent->is_parked()) ids.push_back(rover.agent->id());
  }
  return ids;
}

}  // namespace lsos
