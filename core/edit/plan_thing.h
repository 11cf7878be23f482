// Things of a plan, as a Placemark or a row of a sheet says them: what identifies one, and whether
// two say the same.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plan/declaration.h"
#include "plan/kml_source.h"

namespace lsos {

struct ThingKey {
  enum class Kind { mission, rover, asset, event };
  Kind kind = Kind::mission;
  std::string id;             // of a rover or an asset; of an event, its rover's
  std::int64_t sequence = 0;  // of an event

  auto operator<=>(const ThingKey&) const = default;
};

// `thing`: with one SchemaData. Absent: a rover, asset or event that does not say it.
std::optional<ThingKey> key_of(const SourcePlacemark& thing);
// "MissionInfo", "Rover A", "Asset Camp", "A/20".
std::string key_text(const ThingKey& key);

// The field's text; "" when the thing has none.
std::string field_of(const SourcePlacemark& thing, const std::string& name);

// Whether two texts of a field are one value: "1 km" and "1000 m", "0.50" and "0.5". `type`: name
// of the thing's Schema. Texts of a field that it does not have must be equal.
bool means_same(const std::string& type, const std::string& field, const std::string& a,
                const std::string& b, const Declarations& declarations);
// Whether two texts are equal but for blanks and line ends between words.
bool has_same_words(const std::string& a, const std::string& b);

// The tuples "lon,lat,..." of a text of coordinates, without blanks.
std::vector<std::string> coordinate_tuples(const std::string& coordinates);
// Whether two tuples are one place; altitudes do not count, as all of a plan lies on the ground.
bool is_same_place(const std::string& tuple_a, const std::string& tuple_b);
// Whether the things lie at the same places, also where a ring is closed in one of them only.
bool has_same_places(const SourcePlacemark& a, const SourcePlacemark& b);

}  // namespace lsos
