#include "mission/ahead/expected_begins.h"

#include <algorithm>

#include "mission/ahead/expected_time.h"

namespace lsos {

namespace {

using Times = std::map<PlanEvent::Reference, SimTime>;

// One pass over the events of a rover. `ends`: as known so far, renewed.
void pass(const MissionMachine& machine, const RoverMachine& rover, const RoverModel& model,
          Times& begins, Times& ends) {
  SimTime now{};
  Geodetic at = rover.rover.start;
  for (const EventMachine& each : rover.events) {
    const PlanEvent& event = each.event;
    const PlanEvent::Reference reference{event.rover_id, event.sequence};
    if (event.at) {
      begins[reference] = ends[reference] = *event.at;
      continue;
    }
    SimTime begin = now;
    for (const PlanEvent::Reference& awaited : event.start_after) {
      begin = std::max(begin, ends[awaited]);
    }
    if (event.start_time) begin = std::max(begin, *event.start_time - machine.mission.start_time);
    begins[reference] = begin;
    if (event.is_enabled) {
      now = expected_end(each, model.spec.vehicle, begin, machine.mission.start_time,
                         *machine.mission.planet, at);
    }
    ends[reference] = event.is_enabled ? now : SimTime{};
  }
}

}  // namespace

Times expected_begins(const MissionMachine& machine,
                      const std::map<std::string, RoverModel>& rovers) {
  Times begins, ends;
  // Enabled events do not wait for each other in a circle. Each pass makes one more of them known,
  // whatever the others do.
  std::size_t passes_left = 1;
  for (const RoverMachine& rover : machine.rovers) passes_left += rover.events.size();
  Times before;
  do {
    before = ends;
    for (const RoverMachine& rover : machine.rovers) {
      pass(machine, rover, rovers.at(rover.rover.model()), begins, ends);
    }
  } while (ends != before && --passes_left > 0);
  return begins;
}

}  // namespace lsos
