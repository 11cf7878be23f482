#include "mission/model/plan_revision.h"

#include <fmt/format.h>

#include <algorithm>

namespace lsos {

namespace {

const PlanEvent* referenced_event(const Plan& plan, const PlanEvent::Reference& reference) {
  const auto found = std::ranges::find_if(plan.events, [&](const PlanEvent& event) {
    return event.rover_id == reference.rover_id && event.sequence == reference.sequence;
  });
  return found == plan.events.end() ? nullptr : &*found;
}

std::string name_of(const PlanEvent& event) {
  return fmt::format("{}/{} '{}'", event.rover_id, event.sequence, event.label);
}

// The plan with one of its parts alone, so that its hash is that part's.
std::string hash_of(const MissionInfo& mission) {
  Plan plan;
  plan.mission = mission;
  // How often rows are logged, and how long the mission may take, may change.
  plan.mission.log_interval = plan.mission.parked_log_interval = SimTime{};
  plan.mission.has_max_duration = false;
  return plan.hash();
}

std::string hash_of(const PlanRover& rover) {
  Plan plan;
  plan.rovers = {rover};
  return plan.hash();
}

std::string hash_of(const PlanAsset& asset) {
  Plan plan;
  plan.assets = {asset};
  return plan.hash();
}

// Rovers or assets that are not in both plans, or differ.
template <class Thing>
void check_things(const char* what, const std::vector<Thing>& before,
                  const std::vector<Thing>& after, const Place& place, Faults& faults) {
  for (const Thing& thing : before) {
    const auto found = std::ranges::find(after, thing.id, &Thing::id);
    if (found == after.end()) {
      faults.error(
          place, fmt::format("{} '{}' is missing: it is in the mission that runs", what, thing.id));
    } else if (hash_of(*found) != hash_of(thing)) {
      faults.error(
          found->place,
          fmt::format("{} '{}' differs from the one in the mission that runs", what, thing.id));
    }
  }
  for (const Thing& thing : after) {
    if (std::ranges::count(before, thing.id, &Thing::id) > 0) continue;
    faults.error(thing.place,
                 fmt::format("{} '{}' is not in the mission that runs", what, thing.id));
  }
}

void check_begun(const PlanEvent& event, const PlanEvent* revised, const Place& place,
                 Faults& faults) {
  if (revised == nullptr) {
    faults.error(place, fmt::format("{} is missing: it has begun, and stays", name_of(event)));
  } else if (event_hash(*revised) != event_hash(event)) {
    faults.error(revised->place,
                 fmt::format("{} differs from what has begun, which stays: change later events",
                             name_of(event)));
  }
}

}  // namespace

void check_revision(const Plan& plan, const EventReferences& begun, const Plan& revised,
                    Faults& faults) {
  const Place& place = revised.mission.place;
  if (hash_of(plan.mission) != hash_of(revised.mission)) {
    faults.error(place,
                 "MissionInfo: its planet, StartTime, terrain and Seed must be those of the "
                 "mission that runs; only its log intervals and MaxDuration may change");
  }
  check_things("Rover", plan.rovers, revised.rovers, place, faults);
  check_things("Asset", plan.assets, revised.assets, place, faults);
  std::map<std::string, std::int64_t> last;  // number of each rover's last event that has begun
  for (const PlanEvent::Reference& reference : begun) {
    const PlanEvent* event = referenced_event(plan, reference);
    if (event == nullptr) continue;
    check_begun(*event, referenced_event(revised, reference), place, faults);
    if (!event->at) last[reference.rover_id] = reference.sequence;
  }
  for (const PlanEvent& event : revised.events) {
    const auto found = last.find(event.rover_id);
    const bool is_new = !begun.contains({event.rover_id, event.sequence});
    const PlanEvent* known = referenced_event(plan, {event.rover_id, event.sequence});
    const bool is_same = known != nullptr && event_hash(*known) == event_hash(event);
    if (found == last.end() || !is_new || is_same || event.at) continue;
    if (event.sequence > found->second) continue;
    faults.error(event.place, fmt::format("{} comes before {}/{}, which has begun already",
                                          name_of(event), event.rover_id, found->second));
  }
}

std::map<PlanEvent::Reference, std::int64_t> renumbered_events(const Plan& plan,
                                                               const EventReferences& begun,
                                                               const Plan& revised) {
  std::map<PlanEvent::Reference, std::int64_t> numbers;
  for (const PlanEvent::Reference& reference : begun) {
    const PlanEvent* event = referenced_event(plan, reference);
    if (event == nullptr || referenced_event(revised, reference) != nullptr) continue;
    const auto has_label = [&](const PlanEvent& other) {
      return other.rover_id == event->rover_id && other.label == event->label;
    };
    if (std::ranges::count_if(revised.events, has_label) != 1) continue;
    numbers[reference] = std::ranges::find_if(revised.events, has_label)->sequence;
  }
  return numbers;
}

}  // namespace lsos
