#include "mission/fleet/fleet.h"

#include <algorithm>

namespace lsos {

std::vector<std::string> Fleet::rover_ids() const {
  std::vector<std::string> ids;
  for (const FleetRover& rover : rovers) ids.push_back(rover.agent->id());
  return ids;
}

const FleetRover* Fleet::find(const std::string& rover_id) const {
  const auto found = std::ranges::find_if(
      rovers, [&](const FleetRover& rover) { return rover.agent->id() == rover_id; });
  return found == rovers.end() ? nullptr : &*found;
}

FleetRover* Fleet::find(const std::string& rover_id) {
  return const_cast<FleetRover*>(std::as_const(*this).find(rover_id));
}

std::optional<Vec3> Fleet::place_S_m(const std::string& id) const {
  if (const FleetRover* rover = find(id)) return rover->agent->view().p_S_m;
  for (const StandingAsset& asset : assets) {
    if (asset.plan.id == id) return asset.pose.p_S_m;
  }
  return {};
}

std::optional<Obstacle> Fleet::obstacle(const std::string& rover_id) const {
  const FleetRover* rover = find(rover_id);
  if (rover == nullptr) return {};
  const Footprint footprint = rover->agent->motion().footprint();
  Vec3 center_S_m = rover->agent->view().p_S_m;
  center_S_m.head<2>() = footprint.center_S_m;
  return Obstacle{
      rover_id, center_S_m, {footprint.ahead_S.x(), footprint.ahead_S.y(), 0}, footprint.half_m};
}

const EventRecord& Fleet::record(const PlanEvent::Reference& event) const {
  if (const FleetRover* rover = find(event.rover_id)) {
    const EventSequence& sequence = rover->sequence;
    for (std::size_t i = 0; i < sequence.events().size(); ++i) {
      if (sequence.events()[i].event.sequence == event.sequence) return sequence.records()[i];
    }
  }
  throw InternalError("a StartAfter names an event that is not in the plan");
}

std::size_t Fleet::events_ended() const {
  std::size_t count = 0;
  for (const FleetRover& rover : rovers) {
    count += static_cast<std::size_t>(
        std::ranges::count_if(rover.sequence.records().all(),
                              [](const EventRecord& record) { return record.end.has_value(); }));
  }
  return count;
}

}  // namespace lsos
