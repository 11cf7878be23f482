#include "plan/renumbered.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/quantity.h"
#include "plan/references.h"

namespace lsos {

namespace {

// The field of that name; nullptr where the Placemark has none.
SourceField* field_of(SourcePlacemark& placemark, const std::string& name) {
  for (SourceData& data : placemark.data) {
    const auto found = std::ranges::find(data.fields, name, &SourceField::name);
    if (found != data.fields.end()) return &*found;
  }
  const auto found = std::ranges::find(placemark.plain_data, name, &SourceField::name);
  return found == placemark.plain_data.end() ? nullptr : &*found;
}

// Puts a reference in place of ROVER/`has`, among others between commas.
void replace_reference(std::string& text, const PlanEvent::Reference& reference, std::int64_t has) {
  std::vector<std::string> parts = split_references(text);
  const auto found = std::ranges::find(parts, fmt::format("{}/{}", reference.rover_id, has));
  if (found == parts.end()) return;
  *found = fmt::format("{}/{}", reference.rover_id, reference.sequence);
  text.clear();
  for (const std::string& part : parts) {
    if (!text.empty()) text += ", ";
    for (const char c : part) text += c == ',' ? std::string("\\,") : std::string(1, c);
  }
}

}  // namespace

void renumber_events(KmlSource& source,
                     const std::map<PlanEvent::Reference, std::int64_t>& numbers) {
  for (SourcePlacemark& placemark : source.placemarks) {
    const SourceField* rover = field_of(placemark, "RoverId");
    SourceField* sequence = field_of(placemark, "Sequence");
    const auto number =
        sequence == nullptr ? Parsed<std::int64_t>{} : parse_integer(sequence->text);
    SourceField* start_after = field_of(placemark, "StartAfter");
    for (const auto& [reference, has] : numbers) {
      if (rover != nullptr && rover->text == reference.rover_id && number && *number.value == has) {
        sequence->text = std::to_string(reference.sequence);
      }
      if (start_after != nullptr) replace_reference(start_after->text, reference, has);
    }
  }
}

}  // namespace lsos
