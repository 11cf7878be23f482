#include "edit/plan_thing.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <regex>
#include <sstream>

#include "base/quantity.h"
#include "plan/field_reader.h"

namespace lsos {

namespace {

std::optional<FieldValue> value_of(const FieldDeclaration& field, const std::string& text) {
  const SourceData data{"", "", {{field.name, text}}};
  Faults ignored;
  FieldDeclaration alone = field;
  alone.default_value.reset();
  FieldReader reader({}, data, ignored);
  const FieldValues values = reader.read({&alone, 1}, nullptr);
  const auto found = values.find(field.key);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

// The first two numbers of "lon,lat,alt".
std::optional<std::pair<double, double>> lon_lat(const std::string& tuple) {
  const std::size_t comma = tuple.find(',');
  if (comma == std::string::npos) return {};
  const Unit& one = *find_unit("1");
  const Parsed<double> lon = parse_quantity(tuple.substr(0, comma), one);
  const std::size_t end = std::min(tuple.find(',', comma + 1), tuple.size());
  const Parsed<double> lat = parse_quantity(tuple.substr(comma + 1, end - comma - 1), one);
  if (!lon || !lat) return {};
  return std::pair(*lon.value, *lat.value);
}

bool has_same_tuples(const std::string& a, const std::string& b, bool is_ring) {
  std::vector<std::string> tuples_a = coordinate_tuples(a), tuples_b = coordinate_tuples(b);
  for (std::vector<std::string>* ring : {&tuples_a, &tuples_b}) {
    const bool is_closed = ring->size() > 1 && is_same_place(ring->front(), ring->back());
    if (is_ring && is_closed) ring->pop_back();
  }
  return std::ranges::equal(tuples_a, tuples_b, is_same_place);
}

}  // namespace

std::optional<ThingKey> key_of(const SourcePlacemark& thing) {
  const std::string& type = thing.data.front().schema;
  if (type == "MissionInfo") return ThingKey{};
  ThingKey key;
  key.kind = type == "Rover"   ? ThingKey::Kind::rover
             : type == "Asset" ? ThingKey::Kind::asset
                               : ThingKey::Kind::event;
  key.id = field_of(thing, key.kind == ThingKey::Kind::asset ? "AssetId" : "RoverId");
  if (key.id.empty()) return {};
  if (key.kind != ThingKey::Kind::event) return key;
  const Parsed<std::int64_t> sequence = parse_integer(field_of(thing, "Sequence"));
  if (!sequence) return {};
  key.sequence = *sequence.value;
  return key;
}

std::string key_text(const ThingKey& key) {
  switch (key.kind) {
    case ThingKey::Kind::mission:
      return "MissionInfo";
    case ThingKey::Kind::rover:
      return "Rover " + key.id;
    case ThingKey::Kind::asset:
      return "Asset " + key.id;
    case ThingKey::Kind::event:
      break;
  }
  return fmt::format("{}/{}", key.id, key.sequence);
}

std::string field_of(const SourcePlacemark& thing, const std::string& name) {
  const auto& fields = thing.data.front().fields;
  const auto found = std::ranges::find(fields, name, &SourceField::name);
  return found == fields.end() ? "" : found->text;
}

bool means_same(const std::string& type, const std::string& field, const std::string& a,
                const std::string& b, const Declarations& declarations) {
  if (a == b) return true;
  if (a.empty() || b.empty()) return false;
  for (const auto& list : fields_of(type, declarations)) {
    for (const FieldDeclaration& each : list) {
      if (each.name != field) continue;
      const std::optional<FieldValue> value_a = value_of(each, a), value_b = value_of(each, b);
      return value_a && value_b && *value_a == *value_b;
    }
  }
  return false;
}

bool has_same_words(const std::string& a, const std::string& b) {
  std::istringstream words_a(a), words_b(b);
  using Words = std::istream_iterator<std::string>;
  return std::equal(Words(words_a), Words(), Words(words_b), Words());
}

std::vector<std::string> coordinate_tuples(const std::string& coordinates) {
  static const std::regex around_comma(R"(\s*,\s*)");
  std::istringstream text(std::regex_replace(coordinates, around_comma, ","));
  return {std::istream_iterator<std::string>(text), {}};
}

bool is_same_place(const std::string& tuple_a, const std::string& tuple_b) {
  const auto a = lon_lat(tuple_a), b = lon_lat(tuple_b);
  return a && b ? *a == *b : tuple_a == tuple_b;
}

bool has_same_places(const SourcePlacemark& a, const SourcePlacemark& b) {
  if (a.geometries.empty() || b.geometries.empty()) {
    return a.geometries.empty() && b.geometries.empty();
  }
  const SourceGeometry &one = a.geometries.front(), &other = b.geometries.front();
  const bool is_ring = one.kind == "Polygon";
  return one.kind == other.kind && has_same_tuples(one.coordinates, other.coordinates, is_ring) &&
         std::ranges::equal(
             one.holes, other.holes,
             [](const SourceGeometry::Ring& left, const SourceGeometry::Ring& right) {
               return has_same_tuples(left.coordinates, right.coordinates, true);
             });
}

}  // namespace lsos
