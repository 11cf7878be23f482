#include "interchange/place_book.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/text.h"
#include "interchange/columns.h"
#include "interchange/places.h"
#include "interchange/rover_places.h"
#include "interchange/thing_fields.h"
#include "plan/classify.h"

namespace lsos {

namespace {

constexpr std::size_t most_names = 4;  // of a line; one of more points is better drawn
constexpr std::size_t name_bytes_max = 40;

// Whether a table and an outline can say the name without quotes.
bool is_plain(const std::string& name) {
  const auto is_allowed = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || std::isalnum(byte) != 0 || c == ' ' || c == '-' || c == '_' ||
           c == '.' || c == '\'';
  };
  const bool has_preposition = lower_case(name).find(" at ") != std::string::npos ||
                               lower_case(name).find(" from ") != std::string::npos;
  return !name.empty() && name.size() <= name_bytes_max && std::ranges::all_of(name, is_allowed) &&
         name.find_first_not_of("0123456789.- ") != std::string::npos && !has_preposition &&
         name.front() != '-';
}

// "Ridge" of "To Ridge", "Drive to the ridge"; "" where a label does not begin so.
std::string target_in(const std::string& label) {
  for (const std::string_view words : {"to ", "drive to ", "go to ", "back to ", "return to "}) {
    if (!lower_case(label).starts_with(words)) continue;
    std::string name(trimmed(std::string_view(label).substr(words.size())));
    if (lower_case(name).starts_with("the ")) name = name.substr(4);
    if (name.empty()) return "";
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
  }
  return "";
}

// Whether a label may be what a place is called, such as "Stop 1": its words begin with capitals or
// digits, and none is an event.
bool is_title(const std::string& label, const Declarations& declarations) {
  constexpr int most_words = 3;
  int words = 0;
  for (std::size_t at = 0; at < label.size();) {
    const std::size_t end = std::min(label.find(' ', at), label.size());
    const std::string word = label.substr(at, end - at);
    at = end + 1;
    if (word.empty()) continue;
    const auto first = static_cast<unsigned char>(word[0]);
    const bool is_capital = std::isupper(first) != 0 || std::isdigit(first) != 0;
    if (!is_capital || !name_meant(word, declarations).empty() || ++words > most_words)
      return false;
  }
  return words > 0;
}

std::vector<std::string> points_of(const SourcePlacemark& thing) {
  if (thing.geometries.empty() || thing.geometries.front().kind == "Polygon") return {};
  return tuples_of(thing.geometries.front().coordinates);
}

}  // namespace

PlaceBook::PlaceBook(const KmlSource& things, const Declarations& declarations,
                     const std::vector<Landmark>& landmarks)
    : things_(things), declarations_(declarations), texts_(things.placemarks.size()) {
  // Rovers and assets are places by their ids and names when a table is read.
  for (const SourcePlacemark& thing : things.placemarks) {
    if (thing_type(thing) != "Rover" && thing_type(thing) != "Asset") continue;
    taken_.insert(lower_case(thing.name));
    if (const std::string* id = thing_field(thing, thing_type(thing) + "Id")) {
      taken_.insert(lower_case(*id));
    }
  }
  for (const SourcePlacemark& thing : things.placemarks) {
    if (thing_type(thing) == "Asset") add_asset(thing);
  }
  for (const Landmark& each : landmarks) add(each.name, each.coordinates);
  add_labels();
  // Rovers come last: their starts have names only where events lead there.
  const std::vector<std::string> before = places_before(things, declarations);
  for (const bool is_rover : {false, true}) {
    for (std::size_t i = 0; i < texts_.size(); ++i) {
      const SourcePlacemark& thing = things.placemarks[i];
      if ((thing_type(thing) == "Rover") == is_rover) texts_[i] = named(thing, before[i]);
    }
  }
}

void PlaceBook::add_asset(const SourcePlacemark& asset) {
  const std::string* id = thing_field(asset, "AssetId");
  const std::vector<std::string> points = points_of(asset);
  if (id == nullptr || points.size() != 1 || !is_plain(*id)) return;
  const bool is_sole = std::ranges::count_if(things_.placemarks, [&](const auto& thing) {
                         const std::string* rover = thing_field(thing, "RoverId");
                         return thing_type(thing) == "Rover" && rover != nullptr &&
                                lower_case(*rover) == lower_case(*id);
                       }) == 0;
  const std::string key = place_key(points.front());
  if (is_sole && !key.empty()) places_.emplace(key, Entry{{*id, "", ""}, true});
}

void PlaceBook::add(const std::string& name, const std::string& coordinates) {
  const std::string key = place_key(coordinates);
  if (key.empty() || places_.contains(key) || !is_plain(name)) return;
  const std::string type = name_meant(name, declarations_);
  if (!type.empty()) return;
  std::string own = name;
  for (int i = 2; !taken_.insert(lower_case(own)).second; ++i) own = fmt::format("{} {}", name, i);
  const std::size_t comma = coordinates.find(',');
  const std::size_t end = std::min(coordinates.find(',', comma + 1), coordinates.size());
  places_.emplace(key, Entry{{own, coordinates.substr(0, comma),
                              coordinates.substr(comma + 1, end - comma - 1)},
                             false});
  order_.push_back(key);
}

void PlaceBook::add_labels() {
  const auto for_events = [&](auto&& add_label) {
    for (const SourcePlacemark& thing : things_.placemarks) {
      const auto event = declarations_.events.find(thing_type(thing));
      if (event == declarations_.events.end() || points_of(thing).empty()) continue;
      add_label(thing, points_of(thing).back(), event->second.drives);
    }
  };
  for_events(
      [&](const auto& thing, const std::string& end, bool) { add(target_in(thing.name), end); });
  // What is done at a place is called after it more often than the way there.
  for (const bool is_drive : {false, true}) {
    for_events([&](const auto& thing, const std::string& end, bool drives) {
      if (drives == is_drive && is_title(thing.name, declarations_)) add(thing.name, end);
    });
  }
  for (const SourcePlacemark& thing : things_.placemarks) {
    const std::string* id = thing_field(thing, "RoverId");
    const std::vector<std::string> points = points_of(thing);
    if (thing_type(thing) != "Rover" || id == nullptr || points.size() != 1) continue;
    add("Start " + *id, points.front());
  }
  int count = 0;
  for_events([&](const auto&, const std::string& end, bool) {
    if (!places_.contains(place_key(end))) add(fmt::format("P{}", ++count), end);
  });
}

std::string PlaceBook::name_of(const std::string& tuple, bool only_used) const {
  const std::string key = place_key(tuple);
  const auto found = places_.find(key);
  if (found == places_.end()) return "";
  if (only_used && !found->second.is_asset && !used_.contains(key)) return "";
  return found->second.place.name;
}

std::string PlaceBook::named(const SourcePlacemark& thing, const std::string& before) {
  std::vector<std::string> points = points_of(thing);
  if (points.empty() || thing_type(thing) == "Asset") return "";
  if (thing.geometries.front().kind == "LineString") {
    // A line of places begins where the rover stands, see begin_lines_at_rovers().
    if (points.size() < 2 || before.empty() || place_key(points[0]) != before) return "";
    if (points.size() > 2 && place_key(points[1]) != before) points.erase(points.begin());
    if (points.size() > most_names) return "";
  }
  std::string text;
  for (const std::string& point : points) {
    const std::string name = name_of(point, thing_type(thing) == "Rover");
    if (name.empty()) return "";
    text += (text.empty() ? "" : "; ") + name;
  }
  for (const std::string& point : points) used_.insert(place_key(point));
  return text;
}

std::vector<BookedPlace> PlaceBook::used() const {
  std::vector<BookedPlace> places;
  for (const std::string& key : order_) {
    if (used_.contains(key)) places.push_back(places_.at(key).place);
  }
  return places;
}

std::vector<Landmark> landmarks(const KmlSource& source, const Declarations& declarations) {
  Faults ignored;  // the plan has been read without any
  const Classified ours = classify(source, declarations, ignored);
  std::set<const SourcePlacemark*> things;
  for (const auto* list : {&ours.missions, &ours.rovers, &ours.assets, &ours.events}) {
    for (const PlanPlacemark& each : *list) things.insert(each.placemark);
  }
  std::vector<Landmark> found;
  for (const SourcePlacemark& placemark : source.placemarks) {
    const bool is_point = placemark.geometries.size() == 1 &&
                          placemark.geometries.front().kind == "Point" && !placemark.name.empty();
    if (!is_point || things.contains(&placemark)) continue;
    const auto index = static_cast<std::size_t>(&placemark - source.placemarks.data());
    found.push_back({placemark.name, placemark.geometries.front().coordinates, index});
  }
  return found;
}

}  // namespace lsos
