// Copies of events, for `edit repeat` and `edit mirror`.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "edit/event_names.h"
#include "edit/plan_document.h"

namespace lsos {

struct EventCopy {
  const PlanEvent* event = nullptr;
  PlanEvent::Reference as;  // rover and sequence of the copy
  std::string name;         // "": it has none, and the default label
};

// Sequences for copies of `events`, of one rover in order, behind the last of `rover_id`, from the
// next multiple of ten on and as far apart as they are. `last`: its last sequence, renewed.
std::vector<std::int64_t> sequences_behind(const std::vector<const PlanEvent*>& events,
                                           std::int64_t& last);

// Copies, and where what was copied stands in the plan that was read.
using CopyPlaces = std::map<PlanEvent::Reference, Place>;

struct CopiedEvents {
  std::vector<PlanMark> marks;        // in the order of `copies`
  std::vector<std::string> warnings;  // of what is left out
  CopyPlaces places;
};

// Copies the Placemarks, each behind those beside it, and behind `earlier` copies there. References
// from one to another lead to the copies, others to what they led to; an OnFailure = goto that no
// copy stands for is left out. References of other events by a label that is no longer that of one
// event become ROVER/SEQUENCE.
CopiedEvents copy_events(PlanDocument& document, const EventNames& names,
                         const std::vector<EventCopy>& copies,
                         const std::vector<PlanMark>& earlier = {});

}  // namespace lsos
