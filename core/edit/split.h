// `edit split`: some days of a plan as a plan of their own.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "edit/event_choice.h"
#include "edit/plan_document.h"

namespace lsos {

struct SplitDays {
  int first_day = 1;
  std::vector<const PlanEvent*> events;  // of the days
  std::map<std::string, double> charge;  // of rovers at the beginning, 0..1; others: see split()
};

struct Split {
  int left_out = 0;  // events
  std::vector<std::string> warnings;
};

// Leaves out all other events. The mission starts when the first day begins; rovers start where
// they are expected then. What is not known of their state is warned of: their charge unless it is
// given, a place after a drive without one, and references to events that are left out.
Split split(PlanDocument& document, const SplitDays& days, const EventDays& all_days);

}  // namespace lsos
