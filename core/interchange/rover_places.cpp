#include "interchange/rover_places.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "base/quantity.h"
#include "interchange/places.h"
#include "interchange/thing_fields.h"

namespace lsos {

namespace {

std::string thing_text(const SourcePlacemark& thing, const char* field) {
  const std::string* text = thing_field(thing, field);
  return text == nullptr ? "" : *text;
}

// The key of the last point that is drawn; "" for a polygon, within which the end is not known.
std::string end_of(const SourcePlacemark& thing) {
  if (thing.geometries.empty() || thing.geometries.front().kind == "Polygon") return "";
  const std::vector<std::string> tuples = tuples_of(thing.geometries.front().coordinates);
  return tuples.empty() ? "" : place_key(tuples.back());
}

}  // namespace

std::vector<std::string> places_before(const KmlSource& plan, const Declarations& declarations) {
  std::vector<std::string> before(plan.placemarks.size());
  std::map<std::string, std::string> stands;  // by rover id
  std::vector<std::size_t> events;
  for (std::size_t i = 0; i < plan.placemarks.size(); ++i) {
    const SourcePlacemark& thing = plan.placemarks[i];
    if (thing_type(thing) == "Rover") stands[thing_text(thing, "RoverId")] = end_of(thing);
    if (declarations.events.contains(thing_type(thing))) events.push_back(i);
  }
  std::ranges::stable_sort(events, {}, [&](std::size_t i) {
    const SourcePlacemark& thing = plan.placemarks[i];
    const auto sequence = parse_integer(thing_text(thing, "Sequence"));
    return std::tuple(thing_text(thing, "RoverId"), sequence.value.value_or(0));
  });
  for (const std::size_t i : events) {
    const SourcePlacemark& thing = plan.placemarks[i];
    std::string& place = stands[thing_text(thing, "RoverId")];
    before[i] = place;
    const auto enabled = parse_boolean(thing_text(thing, "Enabled"));
    const bool is_enabled = enabled.value.value_or(true);
    if (is_enabled && declarations.events.at(thing_type(thing)).drives) place = end_of(thing);
  }
  return before;
}

void begin_lines_at_rovers(const std::vector<std::size_t>& ways, const Declarations& declarations,
                           KmlSource& plan) {
  const std::vector<std::string> before = places_before(plan, declarations);
  for (const std::size_t i : ways) {
    SourcePlacemark& thing = plan.placemarks[i];
    if (before[i].empty() || thing.geometries.empty()) continue;
    std::string& line = thing.geometries.front().coordinates;
    if (place_key(tuples_of(line).front()) != before[i]) line = before[i] + " " + line;
  }
}

}  // namespace lsos
