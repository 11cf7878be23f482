#include "product/summary.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "product/column_json.h"
#include "record/columns.h"
#include "record/json_text.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* program = "lsos-host";

Json json_of(const EventRow& event, Instant start) {
  Json object = Json::object();
  for (const Column<EventRow>& column : columns<EventRow>()) {
    object[std::string(column.name)] = json_value(column.value(event, start));
  }
  return object;
}

Json json_of(const RoverSummary& rover) {
  // The library writes non-finite numbers as null.
  Json object = {{"distance_m", rover.distance_m},
                 {"duration_s", rover.duration_s},
                 {"drive_s", rover.drive_s},
                 {"energy_start_j", rover.energy_start_j},
                 {"energy_end_j", rover.energy_end_j},
                 {"energy_used_j", rover.energy_used_j},
                 {"solar_j", rover.solar_j},
                 {"external_j", rover.external_j},
                 {"elevation_gain_m", rover.elevation_gain_m},
                 {"max_slope_rad", rover.max_slope_rad},
                 {"max_slip", rover.max_slip},
                 {"p95_slip", rover.p95_slip},
                 {"resources", nullptr}};
  if (rover.resources) object["resources"] = *rover.resources;
  return object;
}

Json json_of(const RoverDay& day) {
  Json object = {{"rover_id", day.rover_id}, {"day", day.day}};
  for (const DayColumn& column : day_columns()) object[column.name] = day.*column.value;
  return object;
}

bool is_unfinished(const EventRow& event) {
  return event.status == EventStatus::incomplete || event.status == EventStatus::waiting ||
         event.status == EventStatus::running;
}

// Whether a number can be made a time, as a summary may come from anyone.
bool is_time(const Json& value) {
  constexpr double time_max_s = 9e12;  // as from_seconds() takes it
  return value.is_number() && std::abs(value.get<double>()) <= time_max_s;
}

// Whether all values of an object have no parts, and what is named as a time can be one.
bool has_scalars(const Json& object) {
  if (!object.is_object()) return false;
  for (const auto& [key, value] : object.items()) {
    if (!value.is_primitive()) return false;
    if (value.is_number() && key.ends_with("_s") && !is_time(value)) return false;
  }
  return true;
}

bool is_rover(const Json& rover) {
  if (!rover.is_object()) return false;
  Json others = rover;
  const auto resources = rover.find("resources");
  if (resources != rover.end() && resources->is_object()) {
    // Their names may end as those of times do.
    if (!std::ranges::all_of(*resources, [](const Json& amount) { return amount.is_primitive(); }))
      return false;
    others.erase("resources");
  }
  return has_scalars(others);
}

bool is_event(const Json& event) {
  if (!has_scalars(event)) return false;
  const auto is = [&](const char* key, auto type) {
    return event.contains(key) && (event[key].*type)();
  };
  return is("rover_id", &Json::is_string) && is("sequence", &Json::is_number_integer) &&
         is("label", &Json::is_string);
}

bool has_failed(const EventRow& event) { return event.status == EventStatus::failed; }

}  // namespace

const char* to_string(RunStatus status) {
  switch (status) {
    case RunStatus::completed:
      return "completed";
    case RunStatus::failed:
      return "failed";
    case RunStatus::incomplete:
      return "incomplete";
  }
  assertion_failed("every RunStatus has a name", __FILE__, __LINE__);
}

RunStatus run_status(std::span<const EventRow> events) {
  const bool is_incomplete = std::ranges::any_of(events, [](const EventRow& event) {
    return is_unfinished(event) ||
           (event.status == EventStatus::not_started && !event.is_prevented);
  });
  if (is_incomplete) return RunStatus::incomplete;
  return std::ranges::any_of(events, has_failed) ? RunStatus::failed : RunStatus::completed;
}

std::string to_json(const RunSummary& summary) {
  Json rovers = Json::object();
  for (const auto& [id, rover] : summary.rovers) rovers[id] = json_of(rover);
  Json events = Json::array();
  for (const EventRow& event : summary.events) events.push_back(json_of(event, summary.start));
  const bool has_wall_time = summary.wall_s > 0;
  Json document = {
      {"status", to_string(summary.status)},
      {"plan", summary.plan},
      {"log_sha256", summary.log_sha256},
      {"sim_s", summary.sim_s},
      {"wall_s", summary.wall_s},
      {"real_time_factor", has_wall_time ? Json(summary.sim_s / summary.wall_s) : Json()},
      {"rovers", rovers},
      {"events", events},
      {"warnings", summary.warnings},
      {"assumptions", summary.assumptions},
      {"program", program},
  };
  if (!summary.days.empty()) {
    document["days"] = Json::array();
    for (const RoverDay& day : summary.days) document["days"].push_back(json_of(day));
  }
  if (summary.branch) {
    document["branch"] = {{"of", summary.branch->folder},
                          {"log_sha256", summary.branch->log_sha256},
                          {"time_s", seconds(summary.branch->time)},
                          {"changes", summary.branch->changes}};
  }
  if (!summary.from.empty()) document["from"] = summary.from;
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_summary(const std::string& run_dir, const RunSummary& summary) {
  write_file(run_dir + "/summary.json", to_json(summary));
}

bool is_summary(std::string_view json) {
  if (!is_json_object(json)) return false;
  const Json document = Json::parse(json, nullptr, false);
  const auto has = [&](const char* key, auto is_it) {
    const auto found = document.find(key);
    return found != document.end() && is_it(*found);
  };
  const auto is_text = [](const Json& value) { return value.is_string(); };
  const auto is_list_of = [](const Json& list, auto is_it) {
    return list.is_array() && std::ranges::all_of(list, is_it);
  };
  const auto are_texts = [&](const Json& list) { return is_list_of(list, is_text); };
  return has("program", [](const Json& name) { return name == program; }) &&
         has("log_sha256", is_text) && has("status", is_text) && has("plan", is_text) &&
         has("sim_s", is_time) && has("warnings", are_texts) && has("assumptions", are_texts) &&
         has("rovers",
             [](const Json& rovers) {
               return rovers.is_object() && std::ranges::all_of(rovers, is_rover);
             }) &&
         has("events", [&](const Json& events) { return is_list_of(events, is_event); });
}

}  // namespace lsos
