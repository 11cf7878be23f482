// `edit split`: some days of a plan as a plan of their own.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "edit/event_choice.h"
#include "edit/plan_document.h"

namespace lsos {

// How a rover is expected to begin the first day.
struct DayBegin {
  Geodetic place;
  double heading_rad = 0;        // clockwise from true north
  std::optional<double> charge;  // 0..1; absent: it has no battery
  std::string under_way;  // label of an earlier event that ends after the day begins; "": none
  std::vector<std::string> not_in_plan;  // "antenna 'Mast' is up": a plan cannot say it
};

struct SplitDays {
  int first_day = 1;
  std::vector<const PlanEvent*> events;  // of the days
  std::map<std::string, double> charge;  // of rovers at the beginning, 0..1, in place of any other
  std::map<std::string, DayBegin> begins = {};  // by rover; none: see split()
};

struct Split {
  int left_out = 0;  // events
  std::vector<std::string> warnings;
};

// Leaves out all other events. The mission starts when the first day begins; rovers start where and
// with the charge that `begins` says. Without it they start where they are drawn to be then, with
// the plan's charge, which is warned of, as are references to events that are left out and what of
// a rover's state no plan can say.
Split split(PlanDocument& document, const SplitDays& days, const EventDays& all_days);

}  // namespace lsos
