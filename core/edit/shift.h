// `edit shift`: the times of a plan, all earlier or later.
#pragma once

#include <string>

#include "edit/plan_document.h"

namespace lsos {

// What is shifted. Without either: all, with StartTime of MissionInfo.
struct ShiftedPart {
  std::string rover_id;             // "": of all rovers
  const PlanEvent* from = nullptr;  // this event and the later ones of its rover
};

// Moves the times that fields of events say by `by`: UTC times, and where the mission keeps its
// start also those counted from it. Returns the number of fields. Throws InputError where one would
// come before the mission's start.
int shift_times(PlanDocument& document, SimTime by, const ShiftedPart& part);

// Which times of an event move: UTC times, those counted from the mission's start, or both.
enum class ShiftedKind { utc, from_start, all };
// The same for one Placemark of an event.
int shift_times(PlanDocument& document, const PlanMark& mark, SimTime by, ShiftedKind kind);

}  // namespace lsos
