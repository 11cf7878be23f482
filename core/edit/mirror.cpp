#include "edit/mirror.h"

#include <fmt/format.h>

#include "base/error.h"
#include "edit/coordinates.h"
#include "edit/copied_events.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// Where the event names the rover that it now is for, it names the other.
void swap_names(PlanDocument& document, const PlanMark& mark, const Mirror& mirror) {
  for (const FieldDeclaration& field : document.declarations().events.at(mark.type).fields) {
    if (field.names != NameOf::leader && field.names != NameOf::other) continue;
    if (document.field(mark, field.name) == mirror.to) {
      document.set_field(mark, field.name, mirror.from);
    }
  }
}

}  // namespace

Mirrored mirror(PlanDocument& document, const Mirror& mirror) {
  const Plan& plan = document.plan();
  const EventNames names(plan);
  std::vector<const PlanEvent*> events;
  std::int64_t last = 0;
  for (const PlanEvent& event : plan.events) {
    if (event.rover_id == mirror.from) events.push_back(&event);
    if (event.rover_id == mirror.to) last = event.sequence;
  }
  if (events.empty()) {
    throw InputError(
        {}, fmt::format("--from {}: rover {} has no events", mirror.from, quoted(mirror.from)));
  }
  std::vector<EventCopy> copies;
  const std::vector<std::int64_t> sequences = sequences_behind(events, last);
  for (std::size_t i = 0; i < events.size(); ++i) {
    copies.push_back(
        {events[i], {mirror.to, sequences[i]}, document.name(document.mark(*events[i]))});
  }
  CopiedEvents copied = copy_events(document, names, copies);
  for (std::size_t i = 0; i < events.size(); ++i) {
    swap_names(document, copied.marks[i], mirror);
    const bool has_place = events[i]->geometry.kind != GeometryKind::none;
    if (has_place && !mirror.offset_m.isZero()) {
      move_places(document, copied.marks[i], mirror.offset_m);
    }
  }
  return {static_cast<int>(events.size()), std::move(copied.warnings)};
}

}  // namespace lsos
