#include "lua/host/event_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/utf8.h"
#include "lua/host/condition.h"
#include "lua/host/host.h"
#include "mission/model/breakable.h"

namespace lsos {

namespace {

// A condition as a message shows it.
std::string shortened_condition(const std::string& condition) {
  constexpr std::size_t bytes_max = 300;
  return condition.size() <= bytes_max ? condition : beginning(condition, bytes_max) + " ...";
}

// Where all that is drawn lies.
void add_spans(const Plan& plan, ConditionWorld& world) {
  std::vector<Geodetic> places;
  for (const PlanRover& rover : plan.rovers) {
    if (!plan.gaps.unplaced_rovers.contains(rover.id)) places.push_back(rover.start);
  }
  for (const PlanAsset& asset : plan.assets) places.push_back(asset.position);
  for (const PlanEvent& event : plan.events) {
    places.insert(places.end(), event.geometry.points.begin(), event.geometry.points.end());
  }
  if (places.empty()) return;
  const auto [south, north] = std::ranges::minmax(places, {}, &Geodetic::lat_rad);
  const auto [west, east] = std::ranges::minmax(places, {}, &Geodetic::lon_rad);
  constexpr double half_turn_deg = 180;
  world.lat_deg = {degrees(south.lat_rad), degrees(north.lat_rad)};
  const ConditionWorld::Span lon_deg{degrees(west.lon_rad), degrees(east.lon_rad)};
  if (lon_deg.high - lon_deg.low < half_turn_deg) world.lon_deg = lon_deg;
}

// What is the same for all events, and what of the event's rover is. `model`: nullptr: not known.
ConditionWorld condition_world(ConditionWorld world, const std::string& rover_id,
                               const RoverModel* model) {
  world.own_id = rover_id;
  if (model == nullptr) return world;
  world.are_resources_known = true;
  world.speed_max_mps = model->spec.vehicle.speed_max_mps;
  const auto& battery = model->power.battery;
  if (battery) world.battery_capacity_j = battery->capacity_j;
  world.is_without_battery = !battery;
  world.is_without_panels = model->power.panels.empty();
  for (const ResourceSpec& resource : model->power.resources) {
    world.resources.insert(resource.name);
  }
  return world;
}

// What the event would break and its rover does not have, or not so; "": all is well.
std::string breakage_fault(const std::optional<Breakage>& breakage, const PlanRover& rover,
                           const RoverModel& model) {
  if (!breakage) return "";
  constexpr double any_gravity_mps2 = 1;  // names do not depend on it
  return resolve(*breakage, breakable_parts(model, rover.configuration, any_gravity_mps2),
                 rover.type)
      .why;
}

}  // namespace

void check_events(const Plan& plan, const MissionFiles& files, Faults& faults) {
  LuaHost host(*files.catalog);
  std::set<std::string> ids;
  for (const PlanRover& rover : plan.rovers) ids.insert(rover.id);
  for (const PlanAsset& asset : plan.assets) ids.insert(asset.id);
  ids.insert(plan.gaps.unread_ids.begin(), plan.gaps.unread_ids.end());
  ids.erase("");
  ConditionWorld of_plan{"", ids, {}, !plan.gaps.has_ids(), false};
  add_spans(plan, of_plan);
  if (plan.mission.has_max_duration) of_plan.max_duration_s = seconds(plan.mission.max_duration);
  for (const PlanEvent& event : plan.events) {
    const PlanRover* rover = rover_of(plan, event.rover_id);
    const auto model =
        rover == nullptr ? files.rover_models.end() : files.rover_models.find(rover->model());
    const ConditionWorld world = condition_world(
        of_plan, event.rover_id, model == files.rover_models.end() ? nullptr : &model->second);
    const auto check = [&](const char* name, const PlanEvent::Condition& condition) {
      if (condition.text.empty()) return;
      const auto told = [&](const std::string& what) {
        return fmt::format("{} '{}': {} = {}: {}", event.type, event.label, name,
                           shortened_condition(condition.text), what);
      };
      const Place place{event.place.file, condition.line};
      if (const std::string fault = host.condition_fault(condition.text, world); !fault.empty()) {
        return faults.error(place, told(fault));
      }
      const std::string doubt = condition_doubt(condition.text, world);
      if (!doubt.empty()) faults.warning(place, told(doubt));
    };
    check("StartWhen", event.start_when);
    check("SkipWhen", event.skip_when);
    check("StopWhen", event.stop_when);
    check("WarnWhen", event.warn_when);
    const bool has_time = std::ranges::any_of(event.params, [](const auto& param) {
      return std::holds_alternative<Instant>(param.second);
    });
    // A script says of a part of its fields what only the rest would make true; and nothing of an
    // event that is left out.
    if (!event.is_enabled || !event.has_all_params || (has_time && plan.gaps.start_time)) continue;
    try {
      const LuaHost::CheckAnswer answer =
          host.check(event.type, {event.params, {}}, plan.mission.start_time, rover,
                     model == files.rover_models.end() ? nullptr : &model->second);
      const auto text = [&](const std::string& what) {
        return fmt::format("{} '{}': {}", event.type, event.label, what);
      };
      if (!answer.fault.empty()) faults.error(event.place, text(answer.fault));
      if (!answer.warning.empty()) faults.warning(event.place, text(answer.warning));
      if (rover == nullptr || model == files.rover_models.end()) continue;
      const std::string misfit =
          breakage_fault(host.breakage(event.type, {event.params, {}}, plan.mission.start_time),
                         *rover, model->second);
      if (!misfit.empty()) faults.error(event.place, text(misfit));
    } catch (const ScriptError& error) {
      faults.error(event.place, fmt::format("{} '{}': {}", event.type, event.label, error.what()));
    }
  }
}

void check_names(const Plan& plan, const MissionFiles& files, Faults& faults) {
  LuaHost host(*files.catalog);
  const auto change_of = [&](const PlanEvent& event) -> ResourceChange {
    // A script says nothing useful of a time that cannot be read.
    if (plan.gaps.start_time) return {};
    try {
      return host.resource_change(event.type, {event.params, {}}, plan.mission.start_time);
    } catch (const ScriptError& error) {
      faults.error(event.place, fmt::format("{} '{}': {}", event.type, event.label, error.what()));
      return {};
    }
  };
  check_plan_names(plan, files.catalog->declarations(), files.rover_models, files.asset_models,
                   change_of, faults);
}

}  // namespace lsos
