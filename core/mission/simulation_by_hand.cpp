// The part of a mission that a prompt or a scenario has in hand.
#include <algorithm>
#include <utility>

#include "mission/simulation.h"
#include "mission/site.h"

namespace lsos {

std::vector<std::string> Simulation::rover_ids() const {
  std::vector<std::string> ids;
  for (const Rover& rover : rovers_) ids.push_back(rover.agent->id());
  return ids;
}

RoverAgent* Simulation::agent(const std::string& rover_id) {
  for (Rover& rover : rovers_) {
    if (rover.agent->id() == rover_id) return rover.agent.get();
  }
  return nullptr;
}

const EventSequence* Simulation::sequence(const std::string& rover_id) const {
  for (const Rover& rover : rovers_) {
    if (rover.agent->id() == rover_id) return &rover.sequence;
  }
  return nullptr;
}

void Simulation::dispatch(const PlanEvent& event) {
  for (Rover& rover : rovers_) {
    if (rover.agent->id() != event.rover_id) continue;
    rover.sequence.add({event, host_->declarations().events.at(event.type)});
    rover.wake = now_ + exchange_period;
    is_finished_ = false;
    std::vector<PlanEvent>& events = setup_.plan.events;
    const auto at = std::ranges::find_if(events, [&](const PlanEvent& other) {
      return std::tie(other.rover_id, other.sequence) > std::tie(event.rover_id, event.sequence);
    });
    events.insert(at, event);
    return;
  }
  throw InputError(event.place, "there is no rover '" + event.rover_id + "'");
}

void Simulation::take_scripts(std::function<std::unique_ptr<ScriptHost>()> make_host) {
  const std::string state = save();
  setup_.make_host = std::move(make_host);
  build();
  restore(state);
}

void Simulation::take_soil(const Soil& soil) {
  const std::string state = save();
  setup_.terrain.soil = soil;
  // Rovers, light and sight look at the ground: all of them are made again.
  rovers_.clear();
  light_.reset();
  sight_.reset();
  legs_.reset();
  const Geodetic start = setup_.plan.rovers.front().start;
  ground_ = ground_at(setup_.terrain, *setup_.plan.mission.planet, start, setup_.plan.mission.seed);
  check_soil();
  legs_ = std::make_unique<PlannedLegs>(*ground_, setup_.plan.mission.seed);
  for (WayAhead& way : ways_ahead_) way.legs.clear();  // planned in the other soil
  build();
  make_light();
  make_sight();
  restore(state);
}

}  // namespace lsos
