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
    if (!agent.track()) agent.keep_track();
    drive.pursue({*agent.track(), agent.view().speed_mps,
                  agent.motion().footprint_at_rest().half_m.x(), leader.sequence.is_finished()});
    if (!drive.is_driving()) rover.wake = now;
  }
}

}  // namespace lsos
