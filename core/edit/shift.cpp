#include "edit/shift.h"

#include <fmt/format.h>

#include "base/quantity.h"
#include "edit/shifted_time.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

bool is_shifted(const PlanEvent& event, const ShiftedPart& part) {
  if (part.from != nullptr) {
    return event.rover_id == part.from->rover_id && event.sequence >= part.from->sequence;
  }
  return part.rover_id.empty() || event.rover_id == part.rover_id;
}

}  // namespace

int shift_times(PlanDocument& document, const PlanMark& mark, SimTime by, ShiftedKind kind) {
  int count = 0;
  for (const auto& fields : fields_of(mark.type, document.declarations())) {
    for (const FieldDeclaration& declaration : fields) {
      const bool is_moment = declaration.kind == FieldKind::moment;
      if (declaration.kind != FieldKind::utc && !is_moment) continue;
      const std::string text = document.field(mark, declaration.name);
      if (text.empty()) continue;
      const bool is_utc = parse_utc(text).value.has_value();
      if (kind == (is_utc ? ShiftedKind::from_start : ShiftedKind::utc)) continue;
      if (is_utc) {
        document.set_field(mark, declaration.name, shifted_utc(text, by));
      } else {
        const std::string shifted = shifted_duration(text, by);
        if (shifted.starts_with('-')) {
          throw InputError({}, fmt::format("{} {}: {} = {} would be {} before the mission's start",
                                           mark.type, quoted(document.name(mark)), declaration.name,
                                           text, shifted.substr(1)));
        }
        document.set_field(mark, declaration.name, shifted);
      }
      ++count;
    }
  }
  return count;
}

int shift_times(PlanDocument& document, SimTime by, const ShiftedPart& part) {
  const bool is_whole = part.from == nullptr && part.rover_id.empty();
  int count = 0;
  if (is_whole) {
    const PlanMark& mission = document.mission();
    document.set_field(mission, "StartTime", shifted_utc(document.field(mission, "StartTime"), by));
    ++count;
  }
  for (const PlanEvent& event : document.plan().events) {
    if (is_shifted(event, part)) {
      count += shift_times(document, document.mark(event), by,
                           is_whole ? ShiftedKind::utc : ShiftedKind::all);
    }
  }
  return count;
}

}  // namespace lsos
