#include "edit/repeat.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "base/error.h"
#include "base/sim_time.h"
#include "edit/coordinates.h"
#include "edit/copied_events.h"
#include "edit/counted_quantities.h"
#include "edit/references_edit.h"
#include "edit/shift.h"
#include "edit/shifted_time.h"
#include "plan/suggestions.h"
#include "planet/body.h"

namespace lsos {

namespace {

constexpr double same_place_m = 1, home_m = 50;

// A day's different places, and which of them each event goes to.
class Visits {
 public:
  Visits(const Plan& plan, const std::vector<const PlanEvent*>& events) : plan_(plan) {
    for (const PlanEvent* event : events) {
      if (event->geometry.kind != GeometryKind::point) continue;
      const Geodetic& at = event->geometry.points.front();
      if (!is_home(at, event->rover_id) && !place_at(at)) places_.push_back(at);
    }
  }

  int count() const { return static_cast<int>(places_.size()); }
  // The place there; absent: there is none.
  std::optional<std::size_t> place_at(const Geodetic& at) const {
    const auto known = std::ranges::find_if(
        places_, [&](const Geodetic& place) { return is_near(at, place, same_place_m); });
    if (known == places_.end()) return {};
    return static_cast<std::size_t>(known - places_.begin());
  }

 private:
  bool is_near(const Geodetic& a, const Geodetic& b, double within_m) const {
    return surface_distance_m(*plan_.mission.planet, a, b) <= within_m;
  }
  bool is_home(const Geodetic& at, const std::string& rover_id) const {
    return is_near(at, rover_of(plan_, rover_id)->start, home_m) ||
           std::ranges::any_of(plan_.assets, [&](const PlanAsset& asset) {
             return is_near(at, asset.position, home_m);
           });
  }

  const Plan& plan_;
  std::vector<Geodetic> places_;
};

// Puts a copy where its event's places have come to: a Point, or the ends of a line. `places`:
// coordinates by place.
void go_to(PlanDocument& document, const PlanMark& mark, const PlanEvent& event,
           const Visits& visits, const std::vector<std::string>& places) {
  const PlanGeometry& geometry = event.geometry;
  const auto moved = [&](const Geodetic& from) {
    const std::optional<std::size_t> place = visits.place_at(from);
    return place ? places[*place] : std::string();
  };
  if (geometry.kind == GeometryKind::point) {
    const std::string to = moved(geometry.points.front());
    if (!to.empty()) set_point(document, mark, to);
  } else if (geometry.kind == GeometryKind::line) {
    const std::string first = moved(geometry.points.front()), last = moved(geometry.points.back());
    if (!first.empty() || !last.empty()) set_line_ends(document, mark, first, last);
  }
}

// Lines and areas that do not, or not as a whole, go where the places are.
void warn_of_drawn_places(const std::vector<const PlanEvent*>& events, const Visits& visits,
                          std::vector<std::string>& warnings) {
  for (const PlanEvent* event : events) {
    const PlanGeometry& geometry = event->geometry;
    if (geometry.kind == GeometryKind::none || geometry.kind == GeometryKind::point) continue;
    const bool is_line = geometry.kind == GeometryKind::line;
    const bool is_led = is_line && (visits.place_at(geometry.points.front()) ||
                                    visits.place_at(geometry.points.back()));
    if (is_led && geometry.points.size() == 2) continue;
    warnings.push_back(fmt::format(
        "{} {}: {}", event->type, quoted(event->label),
        is_led ? "the ends of its copies' lines follow the places, what is drawn between them stays"
               : fmt::format("its copies stay where it is drawn, as {}",
                             is_line ? "its line does not begin or end at one of the day's Points"
                                     : "only Points and ends of lines follow the places")));
  }
}

void check_places(const Repetition& repetition, const Visits& visits,
                  std::vector<std::string>& warnings) {
  const int wanted = visits.count() * repetition.times;
  const int has = static_cast<int>(repetition.places.size());
  if (has < wanted || visits.count() == 0) {
    throw InputError(
        {repetition.places_file, 0},
        fmt::format("has {} Points; {} are wanted, for {} different Points of the day, "
                    "{} times",
                    has, wanted, visits.count(), repetition.times));
  }
  if (has > wanted) {
    warnings.push_back(fmt::format("{}: the last {} of its {} Points are not used",
                                   repetition.places_file, has - wanted, has));
  }
}

// Events that come behind the days on one of their rovers, and so before the copies.
void warn_of_later_events(const Plan& plan, const Repetition& repetition, const EventDays& days,
                          std::vector<std::string>& warnings) {
  std::set<std::string> rovers;
  for (const PlanEvent* event : repetition.events) rovers.insert(event->rover_id);
  for (const std::string& id : rovers) {
    const auto count = std::ranges::count_if(plan.events, [&](const PlanEvent& event) {
      return event.rover_id == id && days.at(reference_to(event)) > repetition.last_day;
    });
    if (count == 0) continue;
    warnings.push_back(
        fmt::format("rover {} has {} events after day {}; the copies come behind "
                    "them",
                    quoted(id), count, repetition.last_day));
  }
}

// Gives an event without a StartTime that one, since the mission's start, in whole seconds.
void begin_not_before(PlanDocument& document, const PlanMark& mark, SimTime begin) {
  if (!document.field(mark, "StartTime").empty()) return;
  const std::string start = document.field(document.mission(), "StartTime");
  constexpr SimTime second{1'000'000};
  document.set_field(mark, "StartTime", shifted_utc(start, begin / second * second));
}

}  // namespace

Repeated repeat(PlanDocument& document, const Repetition& repetition, const EventDays& days) {
  const Plan& plan = document.plan();
  const EventNames names(plan);
  Repeated repeated;
  const Visits visits(plan, repetition.events);
  const bool has_places = !repetition.places_file.empty();
  if (has_places) {
    check_places(repetition, visits, repeated.warnings);
    warn_of_drawn_places(repetition.events, visits, repeated.warnings);
  }
  warn_of_later_events(plan, repetition, days, repeated.warnings);
  std::set<std::string> kept_names;
  for (const PlanEvent* event : default_targets(plan, names)) kept_names.insert(event->label);
  std::map<std::string, std::int64_t> last;
  for (const PlanEvent& event : plan.events) last[event.rover_id] = event.sequence;
  std::map<std::string, std::vector<const PlanEvent*>> of_rovers;
  for (const PlanEvent* event : repetition.events) of_rovers[event->rover_id].push_back(event);

  for (const PlanEvent* event : repetition.events) {
    const std::string counted = counted_quantities(*event);
    if (counted.empty()) continue;
    repeated.warnings.push_back(
        fmt::format("{} {}: the conditions of its copies name {}, which "
                    "counts from the mission's start",
                    event->type, quoted(event->label), counted));
  }

  const int length = repetition.last_day - repetition.first_day + 1;
  std::vector<PlanMark> earlier;
  for (int time = 1; time <= repetition.times; ++time) {
    std::vector<std::string> places;
    if (has_places) {
      const auto first = repetition.places.begin() + (time - 1) * visits.count();
      places.assign(first, first + visits.count());
    }
    std::vector<EventCopy> copies;
    for (const auto& [id, events] : of_rovers) {
      const std::vector<std::int64_t> sequences = sequences_behind(events, last.at(id));
      for (std::size_t i = 0; i < events.size(); ++i) {
        std::string name = document.name(document.mark(*events[i]));
        const int on_day = days.at(reference_to(*events[i])) + time * length;
        if (!name.empty() && !kept_names.contains(name)) name += fmt::format(" (day {})", on_day);
        copies.push_back({events[i], {id, sequences[i]}, std::move(name)});
      }
    }
    CopiedEvents copied = copy_events(document, names, copies, earlier);
    earlier.insert(earlier.end(), copied.marks.begin(), copied.marks.end());
    std::set<std::string> begun;  // rovers
    for (std::size_t i = 0; i < copies.size(); ++i) {
      const PlanEvent& event = *copies[i].event;
      shift_times(document, copied.marks[i], time * length * day_length, ShiftedKind::all);
      if (event.is_enabled && !event.at && begun.insert(event.rover_id).second) {
        begin_not_before(document, copied.marks[i],
                         repetition.begins.at(reference_to(event)) + time * length * day_length);
      }
      if (has_places) go_to(document, copied.marks[i], event, visits, places);
    }
    repeated.count += static_cast<int>(copies.size());
    repeated.copies.insert(copied.places.begin(), copied.places.end());
    repeated.warnings.insert(repeated.warnings.end(), copied.warnings.begin(),
                             copied.warnings.end());
  }
  return repeated;
}

}  // namespace lsos
