#include "mission/model/plan_requests.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "mission/model/event_times.h"
#include "mission/model/model_doubts.h"
#include "plan/field_reader.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// Length of time for messages: "1.5 h", "45 s".
std::string span_text(SimTime span) {
  const double whole_s = std::abs(seconds(span));
  if (whole_s >= 86400) return fmt::format("{:.4g} d", whole_s / 86400);
  if (whole_s >= 3600) return fmt::format("{:.4g} h", whole_s / 3600);
  if (whole_s >= 60) return fmt::format("{:.4g} min", whole_s / 60);
  return fmt::format("{:.4g} s", whole_s);
}

// The time of an event that takes effect without a turn.
void check_time_of_effect(const PlanEvent& event, const EventDeclaration& declaration,
                          const MissionInfo& mission, Faults& faults) {
  if (!event.at) return;
  const auto field = std::ranges::find(declaration.fields, declaration.at, &FieldDeclaration::key);
  const auto text = [&](const std::string& what) {
    return fmt::format("{} '{}': {} = {}: {}", event.type, event.label, field->name,
                       format_value(*field, event.params.at(field->key)), what);
  };
  if (*event.at < SimTime{}) {
    faults.error(event.place,
                 text(fmt::format("is {} before the mission's StartTime, {}; 0 s is "
                                  "the earliest",
                                  span_text(*event.at), format_utc(mission.start_time))));
  } else if (mission.has_max_duration && *event.at > mission.max_duration) {
    faults.warning(event.place,
                   text(fmt::format("is {} after the mission's end by its MaxDuration, {}: it "
                                    "never takes effect",
                                    span_text(*event.at - mission.max_duration),
                                    format_utc(mission.start_time + mission.max_duration))));
  }
}

// A time of an event after the mission's end.
struct TimeAfterEnd {
  const PlanEvent* event = nullptr;
  Instant time{};
  std::string text;
};

// The earliest time of a rover's events is told and the others are counted: days that are repeated
// beyond the end have many.
void warn_of_times(std::vector<TimeAfterEnd> times, Faults& faults) {
  std::ranges::stable_sort(times, {}, &TimeAfterEnd::time);
  const TimeAfterEnd &first = times.front(), &last = times.back();
  std::string text = first.text;
  const std::size_t more = times.size() - 1;
  if (more > 0) {
    text += fmt::format("; nor {} of rover {}, {}{} of {}",
                        more == 1 ? "does 1 more time" : fmt::format("do {} more times", more),
                        quoted(first.event->rover_id), more == 1 ? "" : "up to ",
                        format_utc(last.time), quoted(last.event->label));
  }
  faults.warning(first.event->place, text);
}

void check_times(const Plan& plan, const Declarations& declarations, Faults& faults) {
  const MissionInfo& mission = plan.mission;
  std::map<std::string, std::vector<TimeAfterEnd>> after_end;  // by rover
  for (const PlanEvent& event : plan.events) {
    if (!event.is_enabled) continue;
    const auto check = [&](const std::string& field, Instant time) {
      const SimTime at = time - mission.start_time;
      const std::string its =
          fmt::format("{} '{}': {} = {}: ", event.type, event.label, field, format_utc(time));
      if (at < SimTime{}) {
        faults.warning(
            event.place,
            its + fmt::format("is {} before the mission's StartTime, {}: nothing waits for it",
                              span_text(at), format_utc(mission.start_time)));
      } else if (mission.has_max_duration && at > mission.max_duration) {
        after_end[event.rover_id].push_back(
            {&event, time,
             its +
                 fmt::format("is {} after the mission's end by its MaxDuration, {}: it never comes",
                             span_text(at - mission.max_duration),
                             format_utc(mission.start_time + mission.max_duration))});
      }
    };
    if (event.start_time) check("StartTime", *event.start_time);
    check_time_of_effect(event, declarations.events.at(event.type), mission, faults);
    for (const FieldDeclaration& field : declarations.events.at(event.type).fields) {
      const auto value = event.params.find(field.key);
      if (field.kind != FieldKind::utc || value == event.params.end()) continue;
      check(field.name, std::get<Instant>(value->second));
    }
  }
  for (const auto& [rover_id, times] : after_end) warn_of_times(times, faults);
}

// Lower bound of an event's driving time: straight from `at` through its points. `at`: place of the
// rover, updated to that at the end; absent: not known.
double least_drive_s(const PlanEvent& event, const EventDeclaration& declaration,
                     const VehicleConfig& vehicle, const Body& body, std::optional<Geodetic>& at) {
  const double length_m = drawn_m(event.geometry, body, at);
  // Within a polygon the rover may stop anywhere; without a geometry it follows what moves.
  const bool is_known =
      event.geometry.kind == GeometryKind::point || event.geometry.kind == GeometryKind::line;
  if (!is_known) {
    at.reset();
    return 0;
  }
  return length_m / drive_speed_mps(event, declaration, vehicle);
}

// Where the speed of a drive comes from, for messages.
const char* speed_source(const PlanEvent& event, const EventDeclaration& declaration,
                         const VehicleConfig& vehicle) {
  const double* requested_mps = find_number(event.params, declaration, NumberRole::drive_speed);
  if (requested_mps == nullptr) return "the rover's cruise speed";
  return *requested_mps > vehicle.speed_max_mps ? "the rover's greatest speed" : "its Speed";
}

void check_timeouts(const Plan& plan, const Declarations& declarations,
                    const std::map<std::string, RoverModel>& rovers, Faults& faults) {
  for (const PlanEvent& event : plan.events) {
    if (!event.is_enabled || !event.timeout || !event.stop_when.text.empty()) continue;
    const EventDeclaration& declaration = declarations.events.at(event.type);
    const auto warn = [&](double needed_s, const std::string& what) {
      if (from_seconds(needed_s) <= *event.timeout) return;
      faults.warning(event.place, fmt::format("{} '{}': Timeout = {}: is less than the {} {}",
                                              event.type, event.label, span_text(*event.timeout),
                                              span_text(from_seconds(needed_s)), what));
    };
    warn(durations_s(event, declaration), "of its durations");
    const PlanRover* rover = rover_of(plan, event.rover_id);
    const auto model = rover == nullptr ? rovers.end() : rovers.find(rover->model());
    if (!declaration.drives || plan.mission.planet == nullptr || model == rovers.end()) continue;
    const VehicleConfig& vehicle = model->second.spec.vehicle;
    std::optional<Geodetic> at;  // absent: only the line counts
    warn(least_drive_s(event, declaration, vehicle, *plan.mission.planet, at),
         fmt::format("that its line takes at {}", speed_source(event, declaration, vehicle)));
  }
}

// Warns about StartTimes earlier than that of an event before it of the same rover.
void check_order_of_times(const Plan& plan, Faults& faults) {
  const PlanEvent* latest = nullptr;
  for (const PlanEvent& event : plan.events) {
    if (!event.is_enabled || !event.start_time) continue;
    if (latest != nullptr && latest->rover_id == event.rover_id &&
        *event.start_time < *latest->start_time) {
      faults.warning(event.place,
                     fmt::format("{} '{}': StartTime = {}: '{}' comes first by its Sequence, and "
                                 "starts at {}",
                                 event.type, event.label, format_utc(*event.start_time),
                                 latest->label, format_utc(*latest->start_time)));
      continue;
    }
    latest = &event;
  }
}

// Tracks, pictures and overlay are straight between two rows of the log.
void check_log_interval(const Plan& plan, const Declarations& declarations,
                        const std::map<std::string, RoverModel>& rovers, Faults& faults) {
  constexpr double longest_m = 100;
  const double interval_s = seconds(plan.mission.log_interval);
  for (const PlanRover& rover : plan.rovers) {
    const auto model = rovers.find(rover.model());
    const bool drives = std::ranges::any_of(plan.events, [&](const PlanEvent& event) {
      return event.rover_id == rover.id && declarations.events.at(event.type).drives;
    });
    if (model == rovers.end() || !drives) continue;
    const double between_m = interval_s * model->second.spec.vehicle.cruise_speed_mps;
    if (between_m <= longest_m) continue;
    faults.warning(
        plan.mission.place,
        fmt::format(
            "MissionInfo: LogInterval = {}: at its usual speed {} drives {:.0f} m from row to row; "
            "its track on maps and in pictures is straight between them",
            span_text(plan.mission.log_interval), quoted(rover.id), between_m));
    return;
  }
}

void check_charges(const Plan& plan, const std::map<std::string, RoverModel>& rovers,
                   Faults& faults) {
  for (const PlanRover& rover : plan.rovers) {
    const auto model = rovers.find(rover.model());
    if (model == rovers.end() || rover.initial_charge == 1) continue;
    if (const auto& battery = model->second.power.battery) {
      if (rover.initial_charge >= battery->reserve) continue;
      faults.warning(
          rover.place,
          fmt::format("Rover '{}': InitialCharge = {:g} %: is below the reserve of {}, "
                      "{:g} %, below which no drive begins or goes on",
                      rover.id, 100 * rover.initial_charge, rover.type, 100 * battery->reserve));
      continue;
    }
    faults.warning(rover.place, fmt::format("Rover '{}': InitialCharge = {}: {} has no battery",
                                            rover.id, rover.initial_charge, rover.type));
  }
}

void check_masts(const Plan& plan, Faults& faults) {
  for (const PlanAsset& asset : plan.assets) {
    if (!asset.antenna_height_m || *asset.antenna_height_m <= highest_mast_m) continue;
    faults.warning(
        asset.place,
        fmt::format("Asset '{}': Height = {:g} m: its antenna would stand on a mast that "
                    "high; is it in cm?",
                    asset.id, *asset.antenna_height_m));
  }
}

// Checks what is requested from an asset whose power is known: one without panels.
void check_supplies(const Plan& plan, const Declarations& declarations,
                    const std::map<std::string, AssetModel>& assets, Faults& faults) {
  for (const PlanEvent& event : plan.events) {
    const auto& fields = declarations.events.at(event.type).fields;
    const auto source = std::ranges::find(fields, NameOf::power_source, &FieldDeclaration::names);
    if (source == fields.end() || !event.is_enabled) continue;
    const auto* asset_id = find_value<std::string>(event.params, source->key);
    if (asset_id == nullptr) continue;
    const auto asset = std::ranges::find(plan.assets, *asset_id, &PlanAsset::id);
    if (asset == plan.assets.end() || !assets.contains(asset->type)) continue;
    const AssetModel& model = assets.at(asset->type);
    if (!model.panels.empty()) continue;
    const auto power =
        std::ranges::find(fields, NumberRole::outside_power, &FieldDeclaration::role);
    if (power == fields.end()) continue;
    const double* requested_w = find_value<double>(event.params, power->key);
    if (requested_w == nullptr || *requested_w <= model.supply_w) continue;
    faults.warning(event.place,
                   fmt::format("{} '{}': {} = {:g} W: '{}' has {:g} W to give", event.type,
                               event.label, power->name, *requested_w, *asset_id, model.supply_w));
  }
}

}  // namespace

void check_plan_spans(const Plan& plan, const Declarations& declarations,
                      const std::map<std::string, RoverModel>& rovers, Faults& faults) {
  if (plan.mission.planet == nullptr) return;
  for (const PlanRover& rover : plan.rovers) {
    const auto model = rovers.find(rover.model());
    std::optional<Geodetic> at;
    if (!plan.gaps.unplaced_rovers.contains(rover.id)) at = rover.start;
    double sum_s = 0;
    for (const PlanEvent& event : plan.events) {
      if (event.rover_id != rover.id || !event.is_enabled) continue;
      const EventDeclaration& declaration = declarations.events.at(event.type);
      if (!event.stop_when.text.empty() || !event.skip_when.text.empty()) {
        if (declaration.drives) at.reset();  // it may have arrived, or not
        continue;
      }
      sum_s += durations_s(event, declaration);
      if (!declaration.drives || model == rovers.end()) continue;
      sum_s +=
          least_drive_s(event, declaration, model->second.spec.vehicle, *plan.mission.planet, at);
    }
    if (from_seconds(sum_s) <= plan.mission.max_duration) continue;
    faults.warning(plan.mission.place,
                   fmt::format("MissionInfo: MaxDuration = {}{}: the durations and drives of the "
                               "events of rover {} alone come to {} if none ends early; those that "
                               "the time does not suffice for end as incomplete",
                               span_text(plan.mission.max_duration),
                               plan.mission.has_max_duration ? "" : " (the default)",
                               quoted(rover.id), span_text(from_seconds(sum_s))));
  }
}

void check_for_events(const Plan& plan, Faults& faults) {
  if (faults.has_errors()) return;
  if (std::ranges::any_of(plan.events, &PlanEvent::is_enabled)) return;
  faults.warning(plan.mission.place,
                 fmt::format("MissionInfo: {}: the rovers only stand where they start",
                             plan.events.empty() ? "the plan has no event"
                                                 : "all events of the plan are disabled"));
}

void check_plan_requests(const Plan& plan, const Declarations& declarations,
                         const std::map<std::string, RoverModel>& rovers,
                         const std::map<std::string, AssetModel>& assets, Faults& faults) {
  if (!plan.gaps.start_time) check_times(plan, declarations, faults);
  check_order_of_times(plan, faults);
  check_timeouts(plan, declarations, rovers, faults);
  check_log_interval(plan, declarations, rovers, faults);
  check_charges(plan, rovers, faults);
  check_masts(plan, faults);
  check_supplies(plan, declarations, assets, faults);
}

}  // namespace lsos
