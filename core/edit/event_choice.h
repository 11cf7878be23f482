// Which events of a plan an edit is for.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plan/plan.h"

namespace lsos {

// The day on which each event begins or is expected to: whole days since the mission's start,
// counted from 1.
using EventDays = std::map<PlanEvent::Reference, int>;

// An event is chosen when it meets all that is given; what is "" or empty is not.
struct EventChoice {
  std::vector<std::string> ranges;  // "SEV1/20", "SEV1/20..40": any of these
  std::string rover_id, label, type;
  int first_day = 0, last_day = 0;  // 0: any

  bool is_given() const {
    return !ranges.empty() || !rover_id.empty() || !label.empty() || !type.empty() || first_day > 0;
  }
};

// The chosen events, by rover and sequence. Throws InputError where a range, a rover, a label or a
// type is none of the plan's, or no event meets all.
std::vector<const PlanEvent*> chosen_events(const Plan& plan, const EventChoice& choice,
                                            const EventDays& days);

// A fault where the plan has no rover of that id, with the nearest; "" is any.
void check_rover(const Plan& plan, const std::string& option, const std::string& rover_id);

}  // namespace lsos
