#include "mission/model/machine.h"

#include <algorithm>

namespace lsos {

MissionMachine synthesise(const Plan& plan, const Declarations& declarations) {
  MissionMachine machine;
  machine.mission = plan.mission;
  for (const PlanRover& rover : plan.rovers) machine.rovers.push_back({rover, {}});
  for (const PlanEvent& event : plan.events) {
    const auto owner = std::ranges::find_if(
        machine.rovers, [&](const RoverMachine& r) { return r.rover.id == event.rover_id; });
    LSOS_ASSERT(owner != machine.rovers.end());
    owner->events.push_back({event, declarations.events.at(event.type)});
  }
  return machine;
}

}  // namespace lsos
