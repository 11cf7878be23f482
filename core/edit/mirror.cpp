#include "edit/mirror.h"

#include <fmt/format.h>

#include <cctype>

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

bool is_in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// A name that says the rover, as "SEV1 to the rim", says the other. An id of one letter may be any
// word.
std::string renamed(const std::string& name, const Mirror& mirror) {
  if (mirror.from.size() < 2) return name;
  std::string text;
  std::size_t begin = 0;
  for (std::size_t at = name.find(mirror.from); at != std::string::npos;
       at = name.find(mirror.from, at + mirror.from.size())) {
    const std::size_t end = at + mirror.from.size();
    const bool is_word =
        (at == 0 || !is_in_word(name[at - 1])) && (end == name.size() || !is_in_word(name[end]));
    if (!is_word) continue;
    text += name.substr(begin, at - begin) + mirror.to;
    begin = end;
  }
  return text + name.substr(begin);
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
    copies.push_back({events[i],
                      {mirror.to, sequences[i]},
                      renamed(document.name(document.mark(*events[i])), mirror)});
  }
  CopiedEvents copied = copy_events(document, names, copies);
  for (std::size_t i = 0; i < events.size(); ++i) {
    swap_names(document, copied.marks[i], mirror);
    const bool has_place = events[i]->geometry.kind != GeometryKind::none;
    if (has_place && !mirror.offset_m.isZero()) {
      move_places(document, copied.marks[i], mirror.offset_m);
    }
  }
  return {static_cast<int>(events.size()), std::move(copied.places), std::move(copied.warnings)};
}

}  // namespace lsos
