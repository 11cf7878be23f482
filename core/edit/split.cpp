#include "edit/split.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/sim_time.h"
#include "base/units.h"
#include "edit/coordinates.h"
#include "edit/counted_quantities.h"
#include "edit/event_names.h"
#include "edit/references_edit.h"
#include "edit/shift.h"
#include "edit/shifted_time.h"
#include "plan/suggestions.h"
#include "planet/body.h"

namespace lsos {

namespace {

class Splitter {
 public:
  Splitter(PlanDocument& document, const SplitDays& days, const EventDays& all_days)
      : document_(document),
        plan_(document.plan()),
        days_(days),
        all_days_(all_days),
        names_(plan_) {
    for (const PlanEvent* event : days.events) kept_.insert(event);
  }

  Split run() {
    reword_events();
    reword_defaults();
    const bool is_later = days_.first_day > 1;
    if (is_later) warn_of_conditions();
    for (const PlanRover& rover : plan_.rovers) {
      const auto begin = days_.begins.find(rover.id);
      if (is_later && begin != days_.begins.end()) {
        begin_as(rover, begin->second);
      } else {
        if (is_later) put(rover);
        charge(rover);
      }
    }
    const SimTime later = (days_.first_day - 1) * day_length;
    const PlanMark& mission = document_.mission();
    document_.set_field(mission, "StartTime",
                        shifted_utc(document_.field(mission, "StartTime"), later));
    for (const PlanEvent& event : plan_.events) {
      const PlanMark& mark = document_.mark(event);
      if (kept_.contains(&event)) {
        shift_times(document_, mark, -later, ShiftedKind::from_start);
      } else {
        document_.dom().remove(mark.element);
        ++split_.left_out;
      }
    }
    if (is_later && days_.begins.empty()) {
      warn(
          "what earlier days deploy, use up or break is not in the new plan; 'run --from' begins "
          "with it, after a run of the days before");
    }
    return std::move(split_);
  }

 private:
  void warn(std::string what) { split_.warnings.push_back(std::move(what)); }

  void reword_events() {
    const Rewording if_kept = [&](const EventReference& reference) -> std::optional<std::string> {
      if (!kept_.contains(&reference.target)) return std::nullopt;
      return reference.text;
    };
    for (const PlanEvent* event : days_.events) {
      for (const std::string& what :
           reword_references(document_, document_.mark(*event), *event, names_, if_kept)) {
        warn(fmt::format("{} {}: {} is left out, with the event that it names", event->type,
                         quoted(event->label), what));
      }
    }
  }

  void reword_defaults() {
    const auto check = [&](const PlanMark& mark, const std::string& text,
                           const std::string& rover_id) {
      const std::string label = goto_label(text);
      const std::vector<const PlanEvent*> targets = names_.meanings(label);
      const bool has_one = std::ranges::any_of(targets, [&](const PlanEvent* event) {
        return kept_.contains(event) && (rover_id.empty() || event->rover_id == rover_id);
      });
      if (label.empty() || has_one) return;
      document_.erase_field(mark, "OnFailure");
      warn(fmt::format("{} {}: OnFailure = {} is left out, with the events that it names",
                       mark.type, quoted(rover_id), text));
    };
    check(document_.mission(), plan_.mission.on_failure.text, "");
    for (const PlanRover& rover : plan_.rovers) {
      check(document_.rover(rover.id), rover.on_failure.text, rover.id);
    }
  }

  void warn_of_conditions() {
    for (const PlanEvent* event : days_.events) {
      const std::string counted = counted_quantities(*event);
      if (counted.empty()) continue;
      warn(
          fmt::format("{} {}: its conditions name {}, which counts from the mission's start, and "
                      "that is later now",
                      event->type, quoted(event->label), counted));
    }
  }

  // As the estimate has it.
  void begin_as(const PlanRover& rover, const DayBegin& begin) {
    const PlanMark& mark = document_.rover(rover.id);
    constexpr double stays_m = 0.01;
    const bool has_moved =
        surface_distance_m(*plan_.mission.planet, begin.place, rover.start) > stays_m;
    if (has_moved) set_point(document_, mark, coordinates_text(begin.place));
    if (has_moved || !rover.heading_rad) {
      const double heading_deg = std::fmod(degrees(begin.heading_rad) + 360, 360);
      document_.set_field(mark, "Heading", fmt::format("{:.2f}", heading_deg));
    }
    const auto given = days_.charge.find(rover.id);
    if (given != days_.charge.end()) {
      document_.set_field(mark, "InitialCharge", fmt::format("{}", given->second));
    } else if (begin.charge) {
      document_.set_field(mark, "InitialCharge", fmt::format("{:.6g}", *begin.charge));
    }
    if (!begin.under_way.empty()) {
      warn(fmt::format("Rover {}: {} goes on when day {} begins; the rover begins as that ends",
                       quoted(rover.id), quoted(begin.under_way), days_.first_day));
    }
    if (!begin.not_in_plan.empty()) {
      warn(
          fmt::format("Rover {}: {} then, which a plan cannot say; events at its beginning can "
                      "make it so, or 'run --from' after a run of the days before",
                      quoted(rover.id), fmt::join(begin.not_in_plan, ", ")));
    }
  }

  // Where the rover is drawn to be when the first day begins.
  void put(const PlanRover& rover) {
    std::optional<Geodetic> at;
    const PlanEvent* vague = nullptr;  // the last drive that says no place
    for (const PlanEvent& event : plan_.events) {
      const bool is_before = event.rover_id == rover.id && event.is_enabled &&
                             all_days_.at(reference_to(event)) < days_.first_day;
      if (!is_before || !document_.declarations().events.at(event.type).drives) continue;
      const bool has_place = !event.geometry.points.empty();
      if (has_place) at = event.geometry.points.back();
      vague = has_place && event.geometry.kind != GeometryKind::polygon ? nullptr : &event;
    }
    const PlanMark& mark = document_.rover(rover.id);
    if (at) set_point(document_, mark, coordinates_text(*at));
    if (at && !document_.field(mark, "Heading").empty()) document_.erase_field(mark, "Heading");
    if (vague != nullptr) {
      warn(fmt::format("Rover {}: where {} {} ends is not known; put its start where it is to be",
                       quoted(rover.id), vague->type, quoted(vague->label)));
    }
  }

  void charge(const PlanRover& rover) {
    const auto given = days_.charge.find(rover.id);
    if (given != days_.charge.end()) {
      document_.set_field(document_.rover(rover.id), "InitialCharge",
                          fmt::format("{}", given->second));
    } else if (days_.first_day > 1) {
      warn(
          fmt::format("Rover {}: begins with the plan's InitialCharge of {:.4g}; --charge {}=0.8 "
                      "gives it another",
                      quoted(rover.id), rover.initial_charge, rover.id));
    }
  }

  PlanDocument& document_;
  const Plan& plan_;
  const SplitDays& days_;
  const EventDays& all_days_;
  EventNames names_;
  std::set<const PlanEvent*> kept_;
  Split split_;
};

}  // namespace

Split split(PlanDocument& document, const SplitDays& days, const EventDays& all_days) {
  return Splitter(document, days, all_days).run();
}

}  // namespace lsos
