// Events of a rover that take effect at a time of their own, whatever it does (PlanEvent::at). They
// need no turn: each begins and ends in one exchange, beside the event whose turn it is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mission/events/event_record.h"
#include "mission/events/turn.h"
#include "mission/model/machine.h"

namespace lsos {

// The one that is next, by its time, then its sequence; absent: none is left.
std::optional<std::size_t> next_timed_event(const std::vector<EventMachine>& events,
                                            const EventRecords& records);
// The exchange at which it takes effect.
SimTime time_of_effect(const PlanEvent& event);

// What became of one.
struct TimedOutcome {
  EventStatus status = EventStatus::completed;
  std::string reason;
  std::vector<PhaseRow> phases;
  std::vector<std::string> warnings;
};
// Runs one from its first phase to its end.
TimedOutcome run_timed_event(const PlanEvent& event, const EventArguments& arguments,
                             const Turn& turn);

}  // namespace lsos
