#include "plan/far_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "base/units.h"
#include "plan/expected_places.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// A leg longer than `far_m` is reported when it exceeds `median_times` the median of the rover's
// other legs (at least `others_least` of them), exceeds `together_m`, or when the line turns back
// at its end. A leg that decimal commas explain is reported from `slip_m` on.
constexpr double far_m = 10e3, median_times = 20, slip_m = 1e3;
constexpr std::size_t others_least = 2;
// A slip explains a place that would be at most this share of its distance away without it.
constexpr double nearer_share = 0.1;
// A place may be meant as written when it is at most this many times as far from the rover's start
// as the place with longitude and latitude exchanged.
constexpr double likely_times = 2;
// A line that begins within `apart_m`, or within `apart_share` of its length, counts as drawn from
// where the rover stands: drawing with a mouse is no more exact. A line that ends where the rover
// stands and begins farther away than `turned_m` is taken to be drawn the wrong way round.
constexpr double apart_m = 200, apart_share = 0.25, turned_m = 70;
// A line belongs to another rover when it begins within `same_place_m` of where that one stands and
// more than `elsewhere_m` from its own rover.
constexpr double same_place_m = 5, elsewhere_m = 30;
// Greatest distance between rovers and assets of one mission.
constexpr double together_m = 100e3;

bool is_origin(const Geodetic& place) { return place.lon_rad == 0 && place.lat_rad == 0; }

std::optional<Geodetic> exchanged(const Geodetic& place) {
  if (std::abs(lon_deg(place)) > 90) return {};
  return geodetic_from_degrees(lat_deg(place), lon_deg(place));
}

// Distance to the place `meant`, if it is so much nearer that it explains `distance_m`.
std::optional<double> explained_m(const Body& body, const Geodetic& from, double distance_m,
                                  const std::optional<Geodetic>& meant) {
  if (!meant) return {};
  const double away_m = surface_distance_m(body, from, *meant);
  return away_m <= nearer_share * distance_m ? std::optional(away_m) : std::nullopt;
}

// Whether a place that looks like 0,0 or like exchanged longitude and latitude may be meant as it
// is: when the distance to it is short, or when it lies near the rover's start.
bool is_plausible(const Body& body, const Geodetic& start, const Geodetic& place,
                  double distance_m) {
  const double away_m = surface_distance_m(body, start, place);
  if (distance_m <= far_m) return true;
  if (is_origin(place)) return away_m <= far_m;
  const auto other = exchanged(place);
  return other && away_m <= likely_times * surface_distance_m(body, start, *other);
}

// Text on what may have been meant by a place; "" where no known slip explains it.
std::string slip_text(const Body& body, const Geodetic& start, const Geodetic& from,
                      const Geodetic& place, double distance_m,
                      const std::optional<Geodetic>& with_comma) {
  if (const auto away_m = explained_m(body, from, distance_m, with_comma)) {
    return fmt::format(
        "; with decimal commas, {:.6g},{:.6g}, it would be {} away: decimals take a "
        "point here",
        lon_deg(*with_comma), lat_deg(*with_comma), distance_text(*away_m));
  }
  if (is_plausible(body, start, place, distance_m)) return "";
  std::string text = exchanged_text(body, from, place);
  if (!text.empty() || !is_origin(place)) return text;
  return "; 0,0 is what tools write for a place that they do not know";
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// One leg of an event; the first leads from the expected place to the event's first point.
struct Leg {
  std::size_t waypoint = 0;  // at its end, counted from 1
  std::optional<Geodetic> from;
  Geodetic to;
  std::optional<Geodetic> next;  // waypoint after it, of the same event
};

std::vector<Leg> legs_of(const DraftEvent& draft, const std::optional<ExpectedPlace>& expected) {
  std::vector<Leg> legs;
  std::optional<Geodetic> from;
  if (expected) from = expected->at;
  for (const Geodetic& point : draft.event.geometry.points) {
    if (!legs.empty()) legs.back().next = point;
    legs.push_back({legs.size() + 1, from, point, {}});
    from = point;
  }
  return legs;
}

class FarWaypoints {
 public:
  FarWaypoints(const Body& body, const std::vector<PlanRover>& rovers, const PlanGaps& gaps,
               Faults& faults)
      : body_(body), faults_(faults) {
    for (const PlanRover& rover : rovers) {
      if (!gaps.unplaced_rovers.contains(rover.id)) starts_.emplace(rover.id, rover.start);
    }
  }

  void measure(const DraftEvent& draft, const std::optional<ExpectedPlace>& expected) {
    if (!draft.event.geometry.points.empty()) {
      ends_[draft.event.rover_id].push_back(draft.event.geometry.points.back());
    }
    for (const Leg& leg : legs_of(draft, expected)) {
      if (!leg.from) continue;
      const double length_m = surface_distance_m(body_, *leg.from, leg.to);
      // Legs of no length, and short ones to the start of a line, are not typical of the rover.
      if (length_m == 0 || (leg.waypoint == 1 && leg.next && length_m <= slip_m)) continue;
      lengths_m_[draft.event.rover_id].push_back(length_m);
    }
  }

  // To be called after measure() of all events. Reports one far waypoint per event at most, and
  // never the leg back from a far place.
  void check(const DraftEvent& draft, const std::optional<ExpectedPlace>& expected) {
    const std::string& rover = draft.event.rover_id;
    const bool is_back = led_away_.contains(rover);
    led_away_.erase(rover);
    for (const Leg& leg : legs_of(draft, expected)) {
      if (!leg.from || (is_back && leg.waypoint == 1)) continue;
      if (!warn_if_far(draft, leg)) {
        warn_if_detached(draft, leg);
        continue;
      }
      const Geodetic& last = draft.event.geometry.points.back();
      if (surface_distance_m(body_, *leg.from, last) > slip_m) led_away_.insert(rover);
      return;
    }
  }

 private:
  // Whether the next waypoint lies near the one before the leg again.
  bool is_spike(const Leg& leg, double distance_m) const {
    return leg.next && surface_distance_m(body_, *leg.from, *leg.next) < nearer_share * distance_m;
  }

  // Warns of a line that begins far from the rover compared with its length: the rover drives to
  // its beginning first, along a leg that is drawn nowhere.
  void warn_if_detached(const DraftEvent& draft, const Leg& leg) {
    const PlanEvent& event = draft.event;
    if (leg.waypoint != 1 || !leg.next || event.geometry.kind != GeometryKind::line) return;
    double line_m = 0;
    for (std::size_t k = 1; k < event.geometry.points.size(); ++k) {
      line_m += surface_distance_m(body_, event.geometry.points[k - 1], event.geometry.points[k]);
    }
    const double distance_m = surface_distance_m(body_, *leg.from, leg.to);
    const Geodetic& last = event.geometry.points.back();
    const double from_end_m = surface_distance_m(body_, *leg.from, last);
    if (distance_m > turned_m && from_end_m < nearer_share * distance_m) {
      faults_.warning(
          {event.place.file, event.geometry.line},
          fmt::format("{}: its line ends where rover {} then is expected, and begins {} "
                      "away, where it drives first: is it drawn the wrong way round, "
                      "or out of its turn?",
                      draft.subject, quoted(event.rover_id), distance_text(distance_m)));
      return;
    }
    if (warn_if_of_another(draft, leg, distance_m)) return;
    // The line leads back towards the rover at once, as when a digit of waypoint 1 is wrong.
    const double next_m = surface_distance_m(body_, *leg.from, *leg.next);
    if (distance_m > apart_m && next_m < distance_m / 4) {
      faults_.warning({event.place.file, event.geometry.line},
                      fmt::format("{}: waypoint 1 is {} from where rover {} then is expected, and "
                                  "waypoint 2 only {}",
                                  draft.subject, distance_text(distance_m), quoted(event.rover_id),
                                  distance_text(next_m)));
      return;
    }
    if (distance_m <= std::max(apart_m, apart_share * line_m)) return;
    faults_.warning(
        {event.place.file, event.geometry.line},
        fmt::format("{}: its line begins {} from where rover {} then is expected, which "
                    "it drives first; the line is {} long",
                    draft.subject, distance_text(distance_m), quoted(event.rover_id),
                    distance_text(line_m)));
  }

  // Warns of a drive that was copied from, or drawn for, another rover.
  bool warn_if_of_another(const DraftEvent& draft, const Leg& leg, double distance_m) {
    const PlanEvent& event = draft.event;
    const auto stands_there = [&](const std::string& rover) {
      const auto is_there = [&](const Geodetic& place) {
        return surface_distance_m(body_, place, leg.to) <= same_place_m;
      };
      const auto start = starts_.find(rover);
      const auto ends = ends_.find(rover);
      return (start != starts_.end() && is_there(start->second)) ||
             (ends != ends_.end() && std::ranges::any_of(ends->second, is_there));
    };
    if (distance_m <= elsewhere_m || stands_there(event.rover_id)) return false;
    const auto other =
        std::ranges::find_if(starts_, [&](const auto& each) { return stands_there(each.first); });
    if (other == starts_.end()) return false;
    faults_.warning(
        {event.place.file, event.geometry.line},
        fmt::format(
            "{}: its line begins where rover {} stands before or after a drive, and {} from "
            "where rover {} then is expected: is its RoverId right?",
            draft.subject, quoted(other->first), distance_text(distance_m),
            quoted(event.rover_id)));
    return true;
  }

  bool warn_if_far(const DraftEvent& draft, const Leg& leg) {
    const PlanEvent& event = draft.event;
    const double distance_m = surface_distance_m(body_, *leg.from, leg.to);
    if (distance_m <= slip_m) return false;
    const bool has_comma = leg.waypoint <= draft.comma_places.size();
    const auto start = starts_.find(event.rover_id);
    const std::string slip = slip_text(
        body_, start == starts_.end() ? *leg.from : start->second, *leg.from, leg.to, distance_m,
        has_comma ? std::optional(draft.comma_places[leg.waypoint - 1]) : std::nullopt);
    std::vector<double> others_m = lengths_m_[event.rover_id];
    others_m.erase(std::ranges::find(others_m, distance_m));
    const bool is_unusual =
        others_m.size() >= others_least && distance_m > median_times * median(std::move(others_m));
    const bool is_far =
        distance_m > far_m && (is_unusual || distance_m > together_m || is_spike(leg, distance_m));
    if (slip.empty() && !is_far) return false;
    const bool is_corner = event.geometry.kind == GeometryKind::polygon;
    const std::string from =
        leg.waypoint == 1
            ? fmt::format("where rover {} then is expected", quoted(event.rover_id))
            : fmt::format("{} {}", is_corner ? "corner" : "waypoint", leg.waypoint - 1);
    faults_.warning({event.place.file, event.geometry.line},
                    fmt::format("{}: {} {} ({:.6f},{:.6f}) is {} from {}{}", draft.subject,
                                is_corner ? "corner" : "waypoint", leg.waypoint, lon_deg(leg.to),
                                lat_deg(leg.to), distance_text(distance_m), from, slip));
    return true;
  }

  const Body& body_;
  Faults& faults_;
  std::map<std::string, Geodetic> starts_;                // by rover; only known ones
  std::map<std::string, std::vector<double>> lengths_m_;  // of legs, by rover
  std::map<std::string, std::vector<Geodetic>> ends_;     // of events, by rover
  std::set<std::string> led_away_;                        // rovers that a far waypoint has led away
};

// Warns of a rover or an asset that is far from the first rover's start.
void check_start(const Body& body, const PlanRover& first, const Geodetic& place,
                 const Place& where, const std::string& subject, Faults& faults) {
  const double distance_m = surface_distance_m(body, first.start, place);
  if (distance_m <= slip_m) return;
  const std::string slip = slip_text(body, first.start, first.start, place, distance_m, {});
  if (slip.empty() && distance_m <= together_m) return;
  faults.warning(where, fmt::format("{}: it is {} from rover {}{}", subject,
                                    distance_text(distance_m), quoted(first.id), slip));
}

// A whole number as people write it before or after a decimal comma.
bool is_whole(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::string distance_text(double distance_m) {
  if (distance_m < 1000) return fmt::format("{:.0f} m", distance_m);
  return fmt::format("{:.{}f} km", distance_m / 1000, distance_m < 10e3 ? 1 : 0);
}

std::string exchanged_text(const Body& body, const Geodetic& from, const Geodetic& place) {
  const double distance_m = surface_distance_m(body, from, place);
  const auto away_m = explained_m(body, from, distance_m, exchanged(place));
  if (!away_m) return "";
  return fmt::format(
      "; with longitude and latitude exchanged it would be {} away: lon,lat is "
      "wanted",
      distance_text(*away_m));
}

std::vector<Geodetic> with_decimal_commas(const std::string& coordinates) {
  std::vector<double> numbers;
  std::size_t begin = 0;
  while ((begin = coordinates.find_first_not_of(" \t\r\n", begin)) != std::string::npos) {
    const std::size_t end =
        std::min(coordinates.find_first_of(" \t\r\n", begin), coordinates.size());
    const std::string_view tuple(coordinates.data() + begin, end - begin);
    begin = end;
    const std::size_t comma = tuple.find(',');
    if (comma == std::string_view::npos) return {};
    const std::string_view whole = tuple.substr(0, comma), decimals = tuple.substr(comma + 1);
    const bool is_number = is_whole(whole) && is_whole(decimals) && std::isdigit(decimals[0]) != 0;
    if (!is_number) return {};
    const std::string text =
        fmt::format("{}.{}", whole.starts_with('+') ? whole.substr(1) : whole, decimals);
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    numbers.push_back(value);
  }
  if (numbers.empty() || numbers.size() % 2 != 0) return {};
  std::vector<Geodetic> places;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    if (std::abs(numbers[i]) > 360 || std::abs(numbers[i + 1]) > 90) return {};
    places.push_back(geodetic_from_degrees(numbers[i], numbers[i + 1]));
  }
  return places;
}

void check_far_places(const std::vector<DraftEvent>& drafts, const MissionInfo& mission,
                      const std::vector<PlanRover>& rovers, const std::vector<PlanAsset>& assets,
                      const PlanGaps& gaps, Faults& faults) {
  const Body& body = *mission.planet;
  const auto first = std::ranges::find_if(
      rovers, [&](const PlanRover& rover) { return !gaps.unplaced_rovers.contains(rover.id); });
  if (first != rovers.end()) {
    if (mission.site) {
      check_start(body, *first, *mission.site, mission.place, "MissionInfo: SiteOrigin", faults);
    }
    for (const PlanRover& rover : rovers) {
      if (gaps.unplaced_rovers.contains(rover.id)) continue;
      check_start(body, *first, rover.start, rover.place, fmt::format("Rover '{}'", rover.id),
                  faults);
    }
    for (const PlanAsset& asset : assets) {
      check_start(body, *first, asset.position, asset.place, fmt::format("Asset '{}'", asset.id),
                  faults);
    }
  }
  FarWaypoints far(body, rovers, gaps, faults);
  const auto visit_drives = [&](auto member) {
    visit_expected_places(drafts, rovers, gaps,
                          [&, member](const DraftEvent& draft, const auto& expected) {
                            if (draft.drives) (far.*member)(draft, expected);
                          });
  };
  visit_drives(&FarWaypoints::measure);
  visit_drives(&FarWaypoints::check);
}

}  // namespace lsos
