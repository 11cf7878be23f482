#include "mission/fleet/convoy.h"

#include "plan/field_reader.h"

namespace lsos {

void keep_tracks(Fleet& fleet, const MissionMachine& machine) {
  for (const RoverMachine& rover : machine.rovers) {
    for (const EventMachine& event : rover.events) {
      if (!event.event.is_enabled) continue;
      const std::string* id = find_name(event.event.params, event.declaration, NameOf::leader);
      FleetRover* leader = id == nullptr ? nullptr : fleet.find(*id);
      if (leader != nullptr) leader->agent->keep_track();
    }
  }
}

std::optional<SimTime> foreseen_wake(const Fleet& fleet, const FleetRover& rover, SimTime now) {
  const RoverDrive& drive = rover.agent->drive();
  const FleetRover* leader = drive.is_foreseen_pursuit() ? fleet.find(drive.leader_id()) : nullptr;
  if (leader != nullptr &&
      (leader->sequence.is_finished() || drive.is_left_behind(leader->agent->drive()))) {
    return now + exchange_period;
  }
  return drive.is_carried() ? std::optional(drive.foreseen()->next_mark()) : std::nullopt;
}

void lead_followers(Fleet& fleet, SimTime now) {
  for (FleetRover& rover : fleet.rovers) {
    if (rover.agent->track() && !rover.agent->is_parked()) rover.agent->keep_track();
  }
  for (FleetRover& rover : fleet.rovers) {
    RoverDrive& drive = rover.agent->drive();
    const std::string leader_id = drive.leader_id();
    if (leader_id.empty()) continue;
    const FleetRover& leader = *fleet.find(leader_id);
    RoverAgent& agent = *leader.agent;
    if (drive.is_foreseen_pursuit()) {
      rover.agent->pursue_foreseen(agent, leader.sequence.is_finished());
      if (!drive.is_driving()) rover.wake = now;
      continue;
    }
    if (!agent.track()) agent.keep_track();
    drive.pursue({*agent.track(), agent.view().speed_mps,
                  agent.motion().footprint_at_rest().half_m.x(), leader.sequence.is_finished()});
    if (!drive.is_driving()) rover.wake = now;
  }
}

}  // namespace lsos
