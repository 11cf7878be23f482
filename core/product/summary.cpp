#include "product/summary.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "product/column_json.h"
#include "record/columns.h"

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
  const Json document = Json::parse(json, nullptr, false);
  if (!document.is_object()) return false;
  const auto name = document.find("program");
  const auto digest = document.find("log_sha256");
  return name != document.end() && *name == program && digest != document.end() &&
         digest->is_string();
}

}  // namespace lsos
