// A simulation that goes on from the state of one with another plan.
#include "mission/simulation.h"

namespace lsos {

void Simulation::go_on_from(Simulation& earlier) {
  std::vector<std::set<std::int64_t>> changed;
  for (std::size_t i = 0; i < fleet_.rovers.size(); ++i) {
    changed.push_back(earlier.fleet_.rovers[i].sequence.revise(machine_.rovers[i]));
  }
  restore(earlier.save());
  for (std::size_t i = 0; i < fleet_.rovers.size(); ++i) {
    if (changed[i].empty()) continue;
    FleetRover& rover = fleet_.rovers[i];
    rover.wake = now_ + exchange_period;
    rover.agent->routes().log_ahead(rover.agent->id(), now_, &changed[i]);
    is_finished_ = false;
  }
}

EventReferences Simulation::begun_events() const {
  EventReferences begun;
  for (const FleetRover& rover : fleet_.rovers) {
    const EventSequence& sequence = rover.sequence;
    for (std::size_t i = 0; i < sequence.events().size(); ++i) {
      if (!sequence.records()[i].has_begun()) continue;
      begun.insert({rover.agent->id(), sequence.events()[i].event.sequence});
    }
  }
  return begun;
}

}  // namespace lsos
