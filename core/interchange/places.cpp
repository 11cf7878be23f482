#include "interchange/places.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/text.h"
#include "interchange/names_in_any_case.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(separator, from), text.size());
    parts.emplace_back(trimmed(std::string_view(text).substr(from, end - from)));
    from = end + 1;
  }
  return parts;
}

std::optional<double> finite_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

// "lon,lat" of "30.1, -89.9"; "" when the text is no pair of numbers.
std::string tuple_of(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 2 || !finite_number(parts[0]) || !finite_number(parts[1])) return "";
  return parts[0] + "," + parts[1];
}

}  // namespace

std::vector<std::string> tuples_of(const std::string& coordinates) {
  std::vector<std::string> tuples;
  constexpr const char* blanks = " \t\r\n";
  for (std::size_t at = coordinates.find_first_not_of(blanks); at != std::string::npos;) {
    const std::size_t end = std::min(coordinates.find_first_of(blanks, at), coordinates.size());
    tuples.push_back(coordinates.substr(at, end - at));
    at = coordinates.find_first_not_of(blanks, end);
  }
  return tuples;
}

std::string place_key(const std::string& tuple) {
  double lon_deg = 0, lat_deg = 0;
  const char* const end = tuple.data() + tuple.size();
  const auto lon = std::from_chars(tuple.data(), end, lon_deg);
  if (lon.ec != std::errc() || lon.ptr == end || *lon.ptr != ',') return "";
  const auto lat = std::from_chars(lon.ptr + 1, end, lat_deg);
  if (lat.ec != std::errc() || (lat.ptr != end && *lat.ptr != ',')) return "";
  return fmt::format("{},{}", lon_deg, lat_deg);
}

void PlaceNames::add(const std::string& name, NamedPlace place) {
  places_.emplace(name, std::move(place));
}

std::vector<std::string> PlaceNames::names() const {
  std::vector<std::string> names;
  for (const auto& [name, place] : places_) {
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  return names;
}

std::string PlaceNames::known_name(const std::string& text) const {
  if (places_.contains(text)) return text;
  return name_in_any_case(text, names());
}

std::string PlaceNames::point(const std::string& name) const {
  const auto [first, last] = places_.equal_range(name);
  const bool is_one = first != last && std::next(first) == last;
  return is_one && first->second.geometry.kind == "Point" ? first->second.geometry.coordinates : "";
}

std::string PlaceNames::name_at(const std::string& key) const {
  for (const auto& [name, place] : places_) {
    const bool is_point = place.geometry.kind == "Point" && !place.is_owner;
    if (is_point && place_key(place.geometry.coordinates) == key) return name;
  }
  return "";
}

std::string PlaceNames::hint(const std::string& name) const { return did_you_mean(name, names()); }

// How a text of several places with other separators is written, or a pair of numbers; else "".
std::string PlaceNames::how_to_write(const std::string& text) const {
  for (const char* separator :
       {"->", "\xe2\x86\x92", ">", "\n", "/", ",", "|", "+", " to ", " - "}) {
    std::vector<std::string> parts;
    bool are_known = true;
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t end = std::min(text.find(separator, from), text.size());
      parts.emplace_back(trimmed(std::string_view(text).substr(from, end - from)));
      from = end + std::string_view(separator).size();
      are_known = are_known && (parts.back().empty() || has(parts.back()));
    }
    std::erase(parts, "");
    if (parts.size() < 2 || !are_known) continue;
    return fmt::format("several places are written with ';' between them: '{}'",
                       fmt::join(parts, "; "));
  }
  std::string numbers = text;
  for (char& c : numbers) {
    if (std::string_view("()[],;\t").find(c) != std::string_view::npos) c = ' ';
  }
  const std::vector<std::string> parts = tuples_of(numbers);
  if (parts.size() != 2 || !finite_number(parts[0]) || !finite_number(parts[1])) return "";
  return fmt::format("a place is written as 'lon, lat': '{}, {}'", parts[0], parts[1]);
}

Parsed<SourceGeometry> PlaceNames::one(const std::string& text) const {
  const std::string known = known_name(text);
  const auto [first, last] = places_.equal_range(known.empty() ? text : known);
  if (!known.empty() && known != text) {
    notes_.add(fmt::format("{} is taken for {}", quoted(text), quoted(known)));
  }
  if (first == last) {
    if (const std::string tuple = tuple_of(text); !tuple.empty()) {
      return {SourceGeometry{"Point", tuple, 0}, {}};
    }
    for (const char* keyword : {"POINT", "LINESTRING", "POLYGON", "MULTI"}) {
      if (text.starts_with(keyword)) return parse_wkt(text);
    }
    const std::vector<std::string> known_names = names();
    if (known_names.empty() && how_to_write(text).empty()) {
      return {{}, "there are no places: a map, or a sheet with names and Lon and Lat, has them"};
    }
    if (const std::string how = how_to_write(text); !how.empty()) {
      return {{}, fmt::format("there is no place {}; {}", quoted(text), how)};
    }
    const std::string nearest = hint(text);
    return {{},
            fmt::format("there is no place {}{}", quoted(text),
                        nearest.empty() ? "; there are " + listed(known_names) : nearest)};
  }
  if (const auto second = std::next(first); second != last) {
    const auto where = [](const NamedPlace& place) {
      return fmt::format("{}:{}", place.place.file, place.place.line);
    };
    return {{},
            fmt::format("there are several places {}: at {} and {}; names must differ",
                        quoted(text), where(first->second), where(second->second))};
  }
  first->second.is_used = true;
  return {first->second.geometry, {}};
}

Parsed<SourceGeometry> PlaceNames::geometry(const std::string& text) const {
  if (text.find(';') == std::string::npos || has(text)) return one(text);
  SourceGeometry line{"LineString", "", 0};
  for (const std::string& part : split(text, ';')) {
    if (part.empty()) continue;
    Parsed<SourceGeometry> place = one(part);
    if (!place) return place;
    if (place.value->kind != "Point" && place.value->kind != "LineString") {
      return {{},
              fmt::format("{} is a {}; a line goes through points and lines", quoted(part),
                          place.value->kind)};
    }
    line.coordinates += (line.coordinates.empty() ? "" : " ") + place.value->coordinates;
  }
  const std::size_t count = tuples_of(line.coordinates).size();
  if (count == 0) return {{}, "names no place"};
  if (count == 1) line.kind = "Point";
  return {std::move(line), {}};
}

bool PlaceNames::is_way(const std::string& text) const {
  if (text.find(';') == std::string::npos || has(text)) return false;
  std::size_t points = 0;
  for (const std::string& part : split(text, ';')) {
    if (part.empty()) continue;
    const Parsed<SourceGeometry> place = one(part);
    if (!place || place.value->kind != "Point") return false;
    ++points;
  }
  return points > 1;
}

std::vector<SourcePlacemark> PlaceNames::used_points() const {
  std::vector<SourcePlacemark> points;
  for (const auto& [name, place] : places_) {
    if (!place.is_used || place.is_owner || place.geometry.kind != "Point") continue;
    SourcePlacemark point;
    point.name = name;
    point.geometries = {place.geometry};
    points.push_back(std::move(point));
  }
  return points;
}

std::vector<std::string> PlaceNames::unused() const {
  std::vector<std::string> names;
  for (const auto& [name, place] : places_) {
    if (!place.is_used) names.push_back(name);
  }
  return names;
}

SourceGeometry own_geometry(const Table& table, const TableRow& row, const Columns& columns,
                            Faults& faults) {
  if (row.geometry) return *row.geometry;
  if (const std::string wkt = columns.text(row, column::wkt); !wkt.empty()) {
    Parsed<SourceGeometry> geometry = parse_wkt(wkt);
    if (geometry) return std::move(*geometry.value);
    faults.error(place_of_cell(table, row.number, columns.find(column::wkt)->index),
                 fmt::format("WKT = {}: {}", quoted(wkt), geometry.why));
    return {};
  }
  std::string numbers[2];
  const char* const names[2] = {column::lon, column::lat};
  const double least_deg[2] = {-180, -90}, most_deg[2] = {360, 90};
  bool is_right = true;
  for (int i = 0; i < 2; ++i) {
    std::string text = columns.text(row, names[i]);
    if (table.has_commas && std::ranges::count(text, ',') == 1) {
      std::ranges::replace(text, ',', '.');
    }
    // Copied from a map: "30.1°".
    if (text.ends_with("\xc2\xb0")) text.resize(text.size() - 2);
    const std::optional<double> value = text.empty() ? std::nullopt : finite_number(text);
    if (!text.empty() && (!value || *value < least_deg[i] || *value > most_deg[i])) {
      is_right = false;
      faults.error(
          place_of_cell(table, row.number, columns.find(names[i])->index),
          fmt::format("{} = {}: a number of degrees from {} to {} is wanted, such as {}", names[i],
                      quoted(text), least_deg[i], most_deg[i], i == 0 ? "30.125" : "-89.5"));
    }
    numbers[i] = std::move(text);
  }
  if (!is_right || (numbers[0].empty() && numbers[1].empty())) return {};
  if (numbers[0].empty() || numbers[1].empty()) {
    const int absent = numbers[0].empty() ? 0 : 1;
    faults.error({table.file, row.number},
                 fmt::format("{} = {}, but {} is empty; a place has both", names[1 - absent],
                             numbers[1 - absent], names[absent]));
    return {};
  }
  return {"Point", numbers[0] + "," + numbers[1], row.number};
}

}  // namespace lsos
