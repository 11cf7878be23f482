// A simulation that goes on from the state of one with another plan, or from what was measured.
#include <algorithm>

#include "base/error.h"
#include "mission/fleet/avoidance.h"
#include "mission/simulation.h"

namespace lsos {

namespace {

// Sequences of events whose legs planned ahead are not among `earlier`.
std::set<std::int64_t> planned_anew(const std::vector<LegAhead>& legs,
                                    const std::vector<LegAhead>& earlier) {
  std::set<std::int64_t> sequences;
  for (const LegAhead& leg : legs) {
    const bool is_known = std::ranges::any_of(earlier, [&](const LegAhead& other) {
      return other.sequence == leg.sequence && other.waypoint == leg.waypoint &&
             other.leg.path_S_m == leg.leg.path_S_m;
    });
    if (!is_known) sequences.insert(leg.sequence);
  }
  return sequences;
}

}  // namespace

void Simulation::go_on_from(Simulation& earlier) {
  LSOS_ASSERT(setup_.plans_ahead);
  std::vector<std::set<std::int64_t>> changed;
  for (std::size_t i = 0; i < fleet_.rovers.size(); ++i) {
    changed.push_back(earlier.fleet_.rovers[i].sequence.revise(machine_.rovers[i]));
  }
  restore(earlier.save());
  const EventReferences begun = begun_events();
  for (std::size_t i = 0; i < fleet_.rovers.size(); ++i) {
    FleetRover& rover = fleet_.rovers[i];
    const std::string& id = rover.agent->id();
    // The log holds the legs that the earlier simulation had planned ahead.
    const bool was_planned = i < earlier.routes_ahead_.rovers.size();
    std::set<std::int64_t> logged =
        planned_anew(routes_ahead_.rovers[i].legs,
                     was_planned ? earlier.routes_ahead_.rovers[i].legs : std::vector<LegAhead>{});
    logged.insert(changed[i].begin(), changed[i].end());
    std::erase_if(logged, [&](std::int64_t sequence) { return begun.contains({id, sequence}); });
    if (!logged.empty()) rover.agent->routes().log_ahead(id, now_, &logged);
    if (changed[i].empty()) continue;
    rover.wake = now_ + exchange_period;
    is_finished_ = false;
  }
}

void Simulation::log_changes() { log_.write_changes(fleet_, now_); }

std::map<std::string, Correction> Simulation::correct(
    const std::map<std::string, MeasuredState>& measured) {
  std::map<std::string, Correction> corrections;
  Faults faults;
  for (const auto& [id, state] : measured) {
    FleetRover* rover = fleet_.find(id);
    LSOS_ASSERT(rover != nullptr);
    try {
      corrections[id] = rover->agent->correct(state);
    } catch (const InputError& error) {
      faults.add(error.faults());
    }
    take_warnings(*rover);
    // Also a mission that was over goes on, until its rovers are logged where they come to rest.
    rover->wake = now_ + exchange_period;
    is_finished_ = false;
  }
  if (!faults.has_errors()) faults.add(overlapping_rovers(fleet_, machine_));
  faults.throw_if_errors();
  return corrections;
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
