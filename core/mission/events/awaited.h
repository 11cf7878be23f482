// What an event waits for before it starts, and the conditions that the plan gives it.
#pragma once

#include <string>

#include "mission/events/turn.h"

namespace lsos {

// Conditions are evaluated when they first matter, then at whole multiples of this.
inline constexpr SimTime condition_period{1'000'000};

inline bool is_condition_due(bool is_first, SimTime now) {
  return is_first || now % condition_period == SimTime{};
}

// Whether one of the plan's conditions on `event` holds now. `name`: that of its field. Returns
// false and sets `fault` when its script fails.
bool holds(const char* name, const PlanEvent::Condition& condition, const PlanEvent& event,
           const std::string& phase, const Turn& turn, std::string& fault);

// What the event whose turn it is waits for, with the present values: "StartTime: ..."; "" when it
// waits for nothing.
std::string awaited_text(const PlanEvent& event, bool waits_for_charge, const Turn& turn);

}  // namespace lsos
