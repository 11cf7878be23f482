#include "plan/geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/utf8.h"
#include "plan/far_places.h"
#include "plan/polygon_rings.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

struct CoordinateFault {
  std::string what;
  int line;
};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// Splits a text into tuples lon,lat[,alt]. Blanks after or before a comma, which KML forbids but
// people write, do not end a tuple.
class Tuples {
 public:
  Tuples(std::string_view text, int line) : rest_(text), line_(line) {}

  // The next tuple; "" at the end of the text.
  std::string next() {
    skip_blanks();
    first_line_ = line_;
    std::string tuple;
    while (!rest_.empty()) {
      if (!is_blank(rest_.front())) {
        tuple += rest_.front();
        rest_.remove_prefix(1);
        continue;
      }
      skip_blanks();
      if (!goes_on(tuple)) break;
    }
    return tuple;
  }
  // Line at which the tuple that next() returned last begins.
  int line() const { return first_line_; }

 private:
  // Whether the text after the blanks behind `tuple` still belongs to it. An empty altitude ends a
  // tuple: after its second comma, a number with a comma of its own is the next longitude.
  bool goes_on(const std::string& tuple) const {
    if (rest_.empty()) return false;
    if (rest_.front() == ',') return true;
    if (tuple.back() != ',') return false;
    if (std::ranges::count(tuple, ',') < 2) return true;
    const std::size_t end = std::ranges::find_if(rest_, is_blank) - rest_.begin();
    const std::size_t next = rest_.find_first_not_of(" \t\r\n", end);
    const bool has_comma = rest_.substr(0, end).find(',') != std::string_view::npos;
    return !has_comma && (next == std::string_view::npos || rest_[next] != ',');
  }

  void skip_blanks() {
    while (!rest_.empty() && is_blank(rest_.front())) {
      line_ += rest_.front() == '\n';
      rest_.remove_prefix(1);
    }
  }

  std::string_view rest_;
  int line_;
  int first_line_ = 0;
};

bool read_number(std::string_view text, double& value) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

// What is wrong with the tuple; "" when nothing is, and `place` is then set.
std::string read_tuple(const std::string& tuple, Geodetic& place) {
  std::array<double, 3> numbers{};
  std::size_t count = 0;
  std::string_view rest = tuple;
  for (bool is_last = false; !is_last; ++count) {
    const std::size_t comma = rest.find(',');
    is_last = comma == std::string_view::npos;
    const std::string_view part = rest.substr(0, comma);
    if (count == numbers.size()) {
      return "has more than lon,lat,alt; a blank parts coordinates, and decimals take a point";
    }
    // GIS tools write "nan" or nothing for an altitude that they do not know.
    const bool has_none = count == 2 && (part.empty() || part == "nan" || part == "NaN");
    if (has_none) continue;
    if (!read_number(part, numbers[count])) {
      return fmt::format("{} is no number; lon,lat or lon,lat,alt in degrees and m is wanted",
                         shown(std::string(part)));
    }
    if (!is_last) rest.remove_prefix(comma + 1);
  }
  if (count < 2) return "has one number; lon,lat or lon,lat,alt is wanted";
  const auto [lon, lat, altitude] = numbers;
  if (std::abs(lat) > 90) {
    const bool looks_swapped = std::abs(lon) <= 90 && std::abs(lat) <= 360;
    return fmt::format("latitude {} is outside -90..90 degrees{}", lat,
                       looks_swapped ? "; this looks like lat,lon, and lon,lat is wanted" : "");
  }
  if (lon < -180 || lon > 360) return fmt::format("longitude {} is outside -180..360 degrees", lon);
  place = geodetic_from_degrees(lon > 180 ? lon - 360 : lon, lat);
  return {};
}

// The places of a text. Only the first wrong coordinate is reported.
std::vector<Geodetic> read_tuples(const std::string& coordinates, int line,
                                  std::vector<CoordinateFault>& wrong) {
  std::vector<Geodetic> places;
  Tuples tuples(coordinates, line);
  for (std::string tuple = tuples.next(); !tuple.empty(); tuple = tuples.next()) {
    const std::string what = read_tuple(tuple, places.emplace_back());
    if (what.empty()) continue;
    wrong.push_back({fmt::format("coordinates '{}': {}",
                                 tuple.size() > 80 ? beginning(tuple, 80) + "..." : tuple, what),
                     tuples.line()});
    break;
  }
  return places;
}

bool is_same(const Geodetic& a, const Geodetic& b) {
  return a.lon_rad == b.lon_rad && a.lat_rad == b.lat_rad;
}

// Reduces a ring, which in KML ends where it begins, to one place per corner; repeated corners in a
// row are merged too.
void read_corners(std::vector<Geodetic>& places, const std::string& what, int line,
                  std::vector<CoordinateFault>& wrong) {
  places.erase(std::unique(places.begin(), places.end(), is_same), places.end());
  if (places.size() > 1 && is_same(places.front(), places.back())) places.pop_back();
  if (places.size() < 3) {
    wrong.push_back({fmt::format("{} has {} corner{}; three or more are wanted", what,
                                 places.size(), places.size() == 1 ? "" : "s"),
                     line});
  }
}

std::vector<Geodetic> read_places(const SourceGeometry& source,
                                  std::vector<CoordinateFault>& wrong) {
  std::vector<Geodetic> places = read_tuples(source.coordinates, source.line, wrong);
  if (!wrong.empty()) return places;
  const bool is_point = source.kind == "Point";
  if (places.empty()) {
    wrong.push_back(
        {fmt::format("{} has no coordinates; lon,lat is wanted", source.kind), source.line});
  } else if (is_point && places.size() > 1) {
    wrong.push_back(
        {fmt::format("Point has {} coordinates; one is wanted", places.size()), source.line});
  } else if (source.kind == "LineString" && places.size() < 2) {
    wrong.push_back({"LineString has one coordinate; two or more are wanted", source.line});
  } else if (source.kind == "Polygon") {
    read_corners(places, "Polygon", source.line, wrong);
    if (!wrong.empty()) return places;
    const std::string fault = outline_fault(places);
    const bool has_commas = !with_decimal_commas(source.coordinates).empty();
    if (!fault.empty()) {
      wrong.push_back({fmt::format("the outline of the Polygon {}{}", fault,
                                   has_commas ? "; decimals take a point here" : ""),
                       source.line});
    }
  }
  return places;
}

// The holes of a polygon whose outline has no fault.
std::vector<std::vector<Geodetic>> read_holes(const SourceGeometry& source,
                                              const std::vector<Geodetic>& outline,
                                              std::vector<CoordinateFault>& wrong) {
  std::vector<std::vector<Geodetic>> holes;
  const auto name = [](std::size_t hole) {
    return fmt::format("hole {} of the Polygon", hole + 1);
  };
  for (const SourceGeometry::Ring& ring : source.holes) {
    std::vector<Geodetic> places = read_tuples(ring.coordinates, ring.line, wrong);
    if (!wrong.empty()) return {};
    if (places.empty()) {
      wrong.push_back({name(holes.size()) + " has no coordinates; lon,lat is wanted", ring.line});
    } else {
      read_corners(places, name(holes.size()), ring.line, wrong);
    }
    if (!wrong.empty()) return {};
    holes.push_back(std::move(places));
  }
  std::size_t hole = 0;
  const std::string fault = hole_fault(outline, holes, hole);
  if (!fault.empty()) wrong.push_back({name(hole) + " " + fault, source.holes[hole].line});
  return holes;
}

}  // namespace

std::string geometries_text(std::span<const GeometryKind> wanted) {
  std::vector<std::string> words;
  const auto add = [&](GeometryKind kind, const char* word) {
    if (std::ranges::find(wanted, kind) != wanted.end()) words.emplace_back(word);
  };
  add(GeometryKind::polygon, "a Polygon");
  add(GeometryKind::line, "a LineString");
  add(GeometryKind::point, "a Point");
  add(GeometryKind::none, "no geometry");
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

std::optional<PlanGeometry> read_geometry(const SourcePlacemark& placemark,
                                          std::span<const GeometryKind> wanted,
                                          const Subject& subject, Faults& faults) {
  const auto refuse = [&](int line, const std::string& what) {
    faults.error({subject.place.file, line}, fmt::format("{}: {}", subject.name, what));
    return std::nullopt;
  };
  const auto is_wanted = [&](GeometryKind kind) {
    return std::ranges::find(wanted, kind) != wanted.end();
  };
  if (placemark.geometries.empty()) {
    if (is_wanted(GeometryKind::none)) return PlanGeometry{};
    return refuse(placemark.line,
                  fmt::format("has no geometry; {} is wanted", geometries_text(wanted)));
  }
  const SourceGeometry& source = placemark.geometries.front();
  // QGIS writes a feature without a place as an empty geometry.
  const bool is_empty = source.holes.empty() && !source.kind.starts_with("Multi") &&
                        source.coordinates.find_first_not_of(" \t\r\n") == std::string::npos;
  if (is_empty && placemark.geometries.size() == 1 && is_wanted(GeometryKind::none)) {
    return PlanGeometry{};
  }
  if (placemark.geometries.size() > 1) {
    return refuse(
        placemark.geometries[1].line,
        fmt::format("has {} geometries; one at most is wanted", placemark.geometries.size()));
  }
  PlanGeometry geometry;
  if (source.kind == "Point") geometry.kind = GeometryKind::point;
  if (source.kind == "LineString") geometry.kind = GeometryKind::line;
  if (source.kind == "Polygon") geometry.kind = GeometryKind::polygon;
  if (geometry.kind == GeometryKind::none || !is_wanted(geometry.kind)) {
    return refuse(source.line,
                  fmt::format("has a {}; {} is wanted", source.kind, geometries_text(wanted)));
  }
  geometry.line = source.line;
  std::vector<CoordinateFault> wrong;
  geometry.points = read_places(source, wrong);
  if (wrong.empty()) geometry.holes = read_holes(source, geometry.points, wrong);
  if (!wrong.empty()) return refuse(wrong.front().line, wrong.front().what);
  return geometry;
}

}  // namespace lsos
