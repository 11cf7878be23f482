#include "edit/plan_notes.h"

#include <fmt/format.h>

#include <algorithm>

namespace lsos {

namespace {

// HTML's comments, which no viewer shows.
constexpr std::string_view note_begin = "<!--lsos-estimate-->", note_end = "<!--/lsos-estimate-->";
constexpr const char* our_prefix = "lsos-";

bool is_ours(KmlElement element) { return attribute(element, "id").starts_with(our_prefix); }

void put_note(PlanDocument& document, const EventNote& note, int number) {
  KmlDom& dom = document.dom();
  const KmlElement placemark = document.mark(*note.event).element;
  const std::string text = fmt::format("{}{}{}", note_begin, note.html, note_end);
  if (const KmlElement description = child(placemark, "description")) {
    append_text(description, text);
  } else {
    dom.add_feature_part(placemark, "description", text);
  }
  const bool has_time =
      child(placemark, "TimeSpan") != nullptr || child(placemark, "TimeStamp") != nullptr;
  if (has_time || note.begin_utc.empty()) return;
  const KmlElement span = dom.add_feature_part(placemark, "TimeSpan", "");
  set_attribute(span, "id", fmt::format("{}time-{}", our_prefix, number));
  dom.add(span, "begin", note.begin_utc);
  if (!note.end_utc.empty()) dom.add(span, "end", note.end_utc);
}

// What the folders are added to: a document without a <Document> has one feature, a Folder.
KmlElement container_of(KmlDom& dom) {
  const KmlElement outermost = dom.container();
  if (outermost != dom.root()) return outermost;
  const KmlElement folder = child(dom.root(), "Folder");
  return folder == nullptr ? outermost : folder;
}

}  // namespace

bool erase_notes(PlanDocument& document) {
  KmlDom& dom = document.dom();
  std::vector<KmlElement> gone;
  for_each_element(dom.root(), [&](KmlElement each) {
    const std::string_view name = local_name(each);
    if ((name == "Style" || name == "Folder" || name == "TimeSpan") && is_ours(each)) {
      gone.push_back(each);
    }
  });
  // Inside a folder that goes nothing else is ours to remove: it has no ids.
  for (const KmlElement each : gone) dom.remove(each);
  bool has_any = !gone.empty();
  for (const KmlElement placemark : dom.placemarks()) {
    const KmlElement description = child(placemark, "description");
    if (description == nullptr) continue;
    const bool was_empty = text_of(description).empty();
    has_any |= erase_text(description, note_begin, note_end);
    if (!was_empty && text_of(description).empty()) dom.remove(description);
  }
  return has_any;
}

void put_notes(PlanDocument& document, const std::vector<EventNote>& notes,
               const std::string& kml) {
  erase_notes(document);
  int number = 0;
  for (const EventNote& note : notes) put_note(document, note, ++number);
  const KmlDom added(kml, document.plan().file);
  const KmlElement container = container_of(document.dom());
  number = 0;
  for (const KmlElement each : children(added.container())) {
    if (local_name(each) == "Style") document.dom().copy_as_feature_part(each, container);
    if (local_name(each) != "Folder") continue;
    const KmlElement folder = document.dom().copy_into(each, container);
    set_attribute(folder, "id", fmt::format("{}folder-{}", our_prefix, ++number));
  }
}

}  // namespace lsos
