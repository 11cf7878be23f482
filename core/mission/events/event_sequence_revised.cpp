// Events of a plan that takes the place of another while a mission runs.
#include <algorithm>

#include "mission/events/event_sequence.h"

namespace lsos {

std::set<std::int64_t> EventSequence::revise(const RoverMachine& machine) {
  EventSequence revised(machine, *ground_);
  std::set<std::int64_t> changed;
  std::optional<std::size_t> current;
  std::size_t after_last = 0;  // behind the last event that has begun in its turn
  for (std::size_t i = 0; i < machine.events.size(); ++i) {
    const PlanEvent& event = machine.events[i].event;
    const auto known = std::ranges::find_if(machine_.events, [&](const EventMachine& other) {
      return other.event.sequence == event.sequence;
    });
    const auto index = static_cast<std::size_t>(known - machine_.events.begin());
    const bool is_same =
        known != machine_.events.end() && event_hash(known->event) == event_hash(event);
    if (!is_same) {
      changed.insert(event.sequence);
      continue;
    }
    EventRecord& record = revised.records_[i];
    record = records_[index];
    if (has_turn_ && index == index_) current = i;
    if (record.has_begun() && !record.is_timed) after_last = i + 1;
  }
  for (const EventMachine& earlier : machine_.events) {
    const bool is_left = std::ranges::any_of(machine.events, [&](const EventMachine& other) {
      return other.event.sequence == earlier.event.sequence;
    });
    if (!is_left) changed.insert(earlier.event.sequence);
  }
  machine_ = machine;
  records_ = revised.records_;
  has_timed_ = revised.has_timed_;
  // An event that waited in its turn gives it up when the plan changes it, or puts another before
  // it.
  const bool is_overtaken = current && std::ranges::any_of(changed, [&](std::int64_t sequence) {
                              return sequence < machine.events[*current].event.sequence;
                            });
  if (!running_ && (!current || is_overtaken)) {
    if (current) records_[*current].status = EventStatus::not_started;
    has_turn_ = false;
  }
  index_ = has_turn_ ? *current : after_last;
  if (changed.empty()) return changed;
  if (has_failed_) {
    records_.prevent_rest(SimTime{}, "an event before it failed", true, false);
  } else {
    is_finished_ = false;
  }
  return changed;
}

}  // namespace lsos
