#include "edit/coordinates.h"

#include <fmt/format.h>

#include <regex>

#include "base/error.h"
#include "base/quantity.h"
#include "plan/mission_reader.h"
#include "plan/suggestions.h"
#include "planet/body.h"
#include "planet/place_text.h"
#include "planet/site_frame.h"

namespace lsos {

namespace {

[[noreturn]] void refuse(PlanDocument& document, const PlanMark& mark) {
  throw InputError(mark.place,
                   fmt::format("{} {}: its place stands in no <coordinates> (but a Camera or a "
                               "gx:Track), and is not moved; draw it again as a placemark or path",
                               mark.type, quoted(document.name(mark))));
}

// In the C locale.
double number(const std::string& text) {
  const Parsed<double> value = parse_quantity(text, *find_unit("1"));
  LSOS_ASSERT(value);
  return *value.value;
}

// A place with its altitude, if any: that follows behind a comma of its own, which a pattern of two
// numbers would take for one between longitude and latitude if it began there.
const std::regex& tuple_pattern() {
  static const std::regex tuple(R"([-+.0-9eE]+(\s*,\s*[-+.0-9eEnNaA]*)+)");
  return tuple;
}

}  // namespace

std::string coordinates_text(const Geodetic& place) {
  return fmt::format("{:.9f},{:.9f}", lon_deg(place), lat_deg(place));
}

std::string moved_coordinates(const std::string& text, const Body& body, const Vec2& offset_m) {
  static const std::regex place(R"(([-+.0-9eE]+)\s*,\s*([-+.0-9eE]+))");
  std::string moved;
  auto rest = text.cbegin();
  for (std::sregex_iterator each(text.begin(), text.end(), tuple_pattern()), none; each != none;
       ++each) {
    moved.append(rest, (*each)[0].first);
    const std::string whole = (*each)[0].str();
    std::smatch parts;
    if (std::regex_search(whole, parts, place)) {
      const Geodetic from = geodetic_from_degrees(number(parts[1]), number(parts[2]));
      const SiteFrame site(body, from);
      moved += coordinates_text(site.geodetic({offset_m.x(), offset_m.y(), 0}));
      moved += parts.suffix();
    } else {
      moved += whole;
    }
    rest = (*each)[0].second;
  }
  return moved.append(rest, text.cend());
}

void move_places(PlanDocument& document, const PlanMark& mark, const Vec2& offset_m) {
  const std::vector<KmlElement> places = coordinates_of(mark.element);
  if (places.empty()) refuse(document, mark);
  for (const KmlElement each : places) {
    set_text(each, moved_coordinates(text_of(each), *document.plan().mission.planet, offset_m));
  }
}

void set_point(PlanDocument& document, const PlanMark& mark, const std::string& coordinates) {
  const std::vector<KmlElement> places = coordinates_of(mark.element);
  if (places.size() != 1) refuse(document, mark);
  set_text(places.front(), coordinates);
}

void keep_site(PlanDocument& document) {
  if (!document.field(document.mission(), site_field).empty()) return;
  document.set_field(document.mission(), site_field, lon_lat_text(site_of(document.plan())));
}

void set_line_ends(PlanDocument& document, const PlanMark& mark, const std::string& first,
                   const std::string& last) {
  const std::vector<KmlElement> places = coordinates_of(mark.element);
  if (places.size() != 1) refuse(document, mark);
  std::string text = text_of(places.front());
  std::vector<std::pair<std::size_t, std::size_t>> tuples;  // begin, length
  for (std::sregex_iterator each(text.begin(), text.end(), tuple_pattern()), none; each != none;
       ++each) {
    tuples.emplace_back(each->position(), each->length());
  }
  LSOS_ASSERT(tuples.size() > 1);
  if (!last.empty()) text.replace(tuples.back().first, tuples.back().second, last);
  if (!first.empty()) text.replace(tuples.front().first, tuples.front().second, first);
  set_text(places.front(), text);
}

}  // namespace lsos
