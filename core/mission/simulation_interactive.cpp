// Interactive control of a running mission, for the prompt and for scenarios.
#include <algorithm>
#include <utility>

#include "mission/model/mission_span.h"
#include "mission/simulation.h"

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
    // The default MaxDuration counts the events of the plan alone, so it no longer applies.
    MissionInfo& mission = setup_.plan.mission;
    if (!mission.has_max_duration) mission.max_duration = longest_mission;
    return;
  }
  throw InputError(event.place, "there is no rover '" + event.rover_id + "'");
}

void Simulation::note_interactive(const std::string& rover_id, const std::string& name,
                                  const std::string& fields_json) {
  const RoverAgent* rover = agent(rover_id);
  LSOS_ASSERT(rover != nullptr);
  const NoteRow row{now_, rover_id, 0, name, fields_json, rover->place_now()};
  if (note_listener_) note_listener_(row);
  if (log_ != nullptr) log_->write(row);
}

}  // namespace lsos
