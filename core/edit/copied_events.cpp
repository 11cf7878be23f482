#include "edit/copied_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "edit/references_edit.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// Names the events by ROVER/SEQUENCE where one of these labels named them.
void name_by_sequence(PlanDocument& document, const EventNames& names,
                      const std::set<std::string>& labels) {
  const Rewording by_sequence = [&](const EventReference& reference) {
    const bool is_ambiguous =
        labels.contains(reference.text) && reference.text == reference.target.label;
    return std::optional(is_ambiguous ? reference_text(reference_to(reference.target))
                                      : reference.text);
  };
  for (const PlanEvent& event : document.plan().events) {
    reword_references(document, document.mark(event), event, names, by_sequence);
  }
}

// The last of the copied Placemarks, and of earlier copies, within each parent.
std::map<KmlElement, KmlElement> last_siblings(PlanDocument& document,
                                               const std::vector<EventCopy>& copies,
                                               const std::vector<PlanMark>& earlier) {
  std::set<KmlElement> copied;
  for (const PlanMark& mark : earlier) copied.insert(mark.element);
  for (const EventCopy& copy : copies) copied.insert(document.mark(*copy.event).element);
  std::map<KmlElement, KmlElement> last;
  for (const KmlElement element : document.dom().placemarks()) {
    if (copied.contains(element)) last[parent_of(element)] = element;
  }
  return last;
}

}  // namespace

std::vector<std::int64_t> sequences_behind(const std::vector<const PlanEvent*>& events,
                                           std::int64_t& last) {
  std::vector<std::int64_t> sequences;
  if (events.empty()) return sequences;
  const std::int64_t first = last < 0 ? 10 : (last / 10 + 1) * 10;
  for (const PlanEvent* event : events) {
    sequences.push_back(first + event->sequence - events.front()->sequence);
  }
  last = sequences.back();
  return sequences;
}

CopiedEvents copy_events(PlanDocument& document, const EventNames& names,
                         const std::vector<EventCopy>& copies,
                         const std::vector<PlanMark>& earlier) {
  std::map<PlanEvent::Reference, PlanEvent::Reference> copy_of;
  std::set<std::string> labels;
  for (const EventCopy& copy : copies) {
    copy_of[reference_to(*copy.event)] = copy.as;
    if (names.count(copy.name) > 0) labels.insert(copy.name);
  }
  name_by_sequence(document, names, labels);
  std::map<KmlElement, KmlElement> last = last_siblings(document, copies, earlier);
  CopiedEvents copied;
  for (const EventCopy& copy : copies) {
    PlanMark mark = document.mark(*copy.event);
    KmlElement& behind = last.at(parent_of(mark.element));
    behind = mark.element = document.dom().copy_behind(mark.element, behind);
    const Rewording lead = [&](const EventReference& reference) -> std::optional<std::string> {
      const auto to = copy_of.find(reference_to(reference.target));
      if (to != copy_of.end()) return reference_text(to->second);
      if (reference.is_goto) return std::nullopt;
      return reference_text(reference_to(reference.target));
    };
    for (const std::string& what : reword_references(document, mark, *copy.event, names, lead)) {
      copied.warnings.push_back(
          fmt::format("{}, a copy of {}: {} is left out, as that is not "
                      "copied with it",
                      reference_text(copy.as), quoted(copy.event->label), what));
    }
    document.set_field(mark, "RoverId", copy.as.rover_id);
    document.set_field(mark, "Sequence", std::to_string(copy.as.sequence));
    if (!copy.name.empty()) document.set_name(mark, copy.name);
    copied.places[copy.as] = mark.place;
    copied.marks.push_back(std::move(mark));
  }
  return copied;
}

}  // namespace lsos
