#include "edit/repeat.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/error.h"
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

constexpr SimTime day{86'400'000'000};
constexpr double same_place_m = 1, home_m = 50;

// Which of the day's different places each event goes to; -1: it stays where it is.
struct Visits {
  std::vector<int> place;
  int count = 0;
};

Visits visits(const Plan& plan, const std::vector<const PlanEvent*>& events) {
  const auto is_near = [&](const Geodetic& a, const Geodetic& b, double within_m) {
    return surface_distance_m(*plan.mission.planet, a, b) <= within_m;
  };
  Visits visits;
  std::vector<Geodetic> places;
  for (const PlanEvent* event : events) {
    visits.place.push_back(-1);
    if (event->geometry.kind != GeometryKind::point) continue;
    const Geodetic& at = event->geometry.points.front();
    const bool is_home = is_near(at, rover_of(plan, event->rover_id)->start, home_m) ||
                         std::ranges::any_of(plan.assets, [&](const PlanAsset& asset) {
                           return is_near(at, asset.position, home_m);
                         });
    if (is_home) continue;
    const auto known = std::ranges::find_if(
        places, [&](const Geodetic& place) { return is_near(at, place, same_place_m); });
    visits.place.back() = static_cast<int>(known - places.begin());
    if (known == places.end()) places.push_back(at);
  }
  visits.count = static_cast<int>(places.size());
  return visits;
}

void check_places(const Repetition& repetition, const Visits& visits,
                  std::vector<std::string>& warnings) {
  const int wanted = visits.count * repetition.times;
  const int has = static_cast<int>(repetition.places.size());
  if (has < wanted || visits.count == 0) {
    throw InputError(
        {repetition.places_file, 0},
        fmt::format("has {} Points; {} are wanted, for {} different Points of the day, "
                    "{} times",
                    has, wanted, visits.count, repetition.times));
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
  const Visits visited = visits(plan, repetition.events);
  const bool has_places = !repetition.places_file.empty();
  if (has_places) check_places(repetition, visited, repeated.warnings);
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
  for (int time = 1; time <= repetition.times; ++time) {
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
    CopiedEvents copied = copy_events(document, names, copies);
    std::set<std::string> begun;  // rovers
    for (std::size_t i = 0; i < copies.size(); ++i) {
      const PlanEvent& event = *copies[i].event;
      shift_times(document, copied.marks[i], time * length * day, ShiftedKind::all);
      if (event.is_enabled && !event.at && begun.insert(event.rover_id).second) {
        begin_not_before(document, copied.marks[i],
                         repetition.begins.at(reference_to(event)) + time * length * day);
      }
      if (!has_places || visited.place[i] < 0) continue;
      const auto place = static_cast<std::size_t>((time - 1) * visited.count + visited.place[i]);
      set_point(document, copied.marks[i], repetition.places[place]);
    }
    repeated.count += static_cast<int>(copies.size());
    repeated.warnings.insert(repeated.warnings.end(), copied.warnings.begin(),
                             copied.warnings.end());
  }
  return repeated;
}

}  // namespace lsos
