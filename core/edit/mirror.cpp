#include "edit/mirror.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

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

// Whether the text begins with a part of a word: a letter of any script, a digit, '_'. Dashes,
// quotes and blanks outside ASCII are none.
bool begins_in_word(std::string_view text) {
  if (text.empty()) return false;
  const auto first = static_cast<unsigned char>(text.front());
  if (first < 0x80) return std::isalnum(first) != 0 || first == '_';
  return !text.starts_with("\xc2") && !text.starts_with("\xe2\x80") &&
         !text.starts_with("\xe2\x81");
}

bool ends_in_word(std::string_view text) {
  std::size_t last = text.size();
  while (last > 0 && (static_cast<unsigned char>(text[--last]) & 0xC0) == 0x80) continue;
  return begins_in_word(text.substr(last));
}

// The longest of the ids that stands there as a word; "" for none.
std::string_view id_at(std::string_view text, std::size_t at, const std::vector<std::string>& ids) {
  std::string_view longest;
  if (ends_in_word(text.substr(0, at))) return longest;
  for (const std::string& id : ids) {
    const std::string_view rest = text.substr(at);
    if (id.size() <= longest.size() || !rest.starts_with(id)) continue;
    if (!begins_in_word(rest.substr(id.size()))) longest = id;
  }
  return longest;
}

std::vector<std::string> ids_of(const Plan& plan) {
  std::vector<std::string> ids;
  for (const PlanRover& rover : plan.rovers) ids.push_back(rover.id);
  for (const PlanAsset& asset : plan.assets) ids.push_back(asset.id);
  return ids;
}

// A name that says one of the two rovers, as "SEV1 to the rim", says the other. An id of one letter
// may be any word: where there is one, names stay as they are.
std::string renamed(const std::string& name, const Mirror& mirror,
                    const std::vector<std::string>& ids) {
  if (mirror.from.size() < 2 || mirror.to.size() < 2) return name;
  std::string text;
  for (std::size_t at = 0; at < name.size();) {
    const std::string_view id = id_at(name, at, ids);
    text += id == mirror.from ? mirror.to
            : id == mirror.to ? mirror.from
                              : name.substr(at, std::max<std::size_t>(id.size(), 1));
    at += std::max<std::size_t>(id.size(), 1);
  }
  return text;
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
  const std::vector<std::string> ids = ids_of(plan);
  const std::vector<std::int64_t> sequences = sequences_behind(events, last);
  for (std::size_t i = 0; i < events.size(); ++i) {
    copies.push_back({events[i],
                      {mirror.to, sequences[i]},
                      renamed(document.name(document.mark(*events[i])), mirror, ids)});
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
