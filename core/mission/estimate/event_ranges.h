// How sure an estimate of events is: what drives may take less or more and what a Sun along the
// horizon may give, carried on through the events that follow.
#pragma once

#include <vector>

#include "mission/estimate/event_estimate.h"
#include "mission/routes/drive_slack.h"
#include "plan/plan.h"

namespace lsos {

// Charge from which a battery counts as full.
inline constexpr double full_charge = 1 - 1e-3;
// Ranges narrower than these are none: the quantity then is as sure as a number says. The charge
// is a range wherever the energy of the event is one.
inline constexpr double end_told_s = 10, energy_told = 0.01, charge_told = 0.005;

// An event with what is known of it beyond its estimate.
struct DoubtedEvent {
  EventEstimate* estimate = nullptr;
  const PlanEvent* planned = nullptr;
  DriveDoubt drives;      // of its own drives
  double capacity_j = 0;  // of the rover's battery; 0: it has none
  // What the battery may have less or more by the Sun, in its course and in the wait for it: what
  // panels give, and what loads take that the Sun switches.
  double sun_less_j = 0, sun_more_j = 0;
  double loads_less_j = 0, loads_more_j = 0;  // what such loads may use in its course
  bool was_full = false;                      // the battery, at some time of these
  // Power into the battery at the end of an event that ends at a charge; 0: it does not.
  double charging_w = 0;
};

// Sets the ranges of the estimates. An event begins early or late as what it waits for does: the
// event before it, those in StartAfter; a clock (StartTime, a time of the day that an event ends
// at) and a condition are sure. One that ends at a charge ends the later the less there was as it
// began, and that charge is sure. Energy counts from where the battery was full.
void add_ranges(const std::vector<DoubtedEvent>& events, Instant mission_start);

}  // namespace lsos
