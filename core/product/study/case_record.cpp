#include "product/study/case_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "planet/body.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;

Draw::Value value_of(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  return json.get<std::string>();
}

std::string text_in(const Json& event, const char* key) {
  return event.at(key).is_string() ? event.at(key).get<std::string>() : "";
}

// "SEV1/20 'Leg 2' failed: the battery is empty".
std::string event_text(const Json& event, const char* what) {
  const std::string reason = text_in(event, "reason");
  return fmt::format("{}/{} '{}' {}{}{}", text_in(event, "rover_id"),
                     event.at("sequence").get<std::int64_t>(), text_in(event, "label"), what,
                     reason.empty() ? "" : ": ", reason);
}

// The first event, by the time at which it ended, with that status; nullptr: none has it.
const Json* first_with(const Json& events, const char* status) {
  const Json* first = nullptr;
  const auto end_s = [](const Json& event) {
    return event.at("end_s").is_number() ? event.at("end_s").get<double>() : 0;
  };
  for (const Json& event : events) {
    if (text_in(event, "status") != status) continue;
    if (first == nullptr || end_s(event) < end_s(*first)) first = &event;
  }
  return first;
}

Json object_of(const CaseRecord::Values& values) {
  Json object = Json::object();
  for (const auto& [name, value] : values) {
    std::visit([&, &key = name](const auto& each) { object[key] = each; }, value);
  }
  return object;
}

CaseRecord::Values values_in(const Json& object) {
  CaseRecord::Values values;
  for (const auto& [name, value] : object.items()) values.emplace_back(name, value_of(value));
  return values;
}

Json event_json(const CaseRecord::Event& event) {
  const auto number = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  Json json{{"rover_id", event.rover_id},   {"sequence", event.sequence},
            {"status", event.status},       {"reason", event.reason},
            {"end_s", number(event.end_s)}, {"charge", number(event.charge)},
            {"lon_deg", nullptr},           {"lat_deg", nullptr}};
  if (event.place) {
    json["lon_deg"] = lon_deg(*event.place);
    json["lat_deg"] = lat_deg(*event.place);
  }
  return json;
}

CaseRecord::Event event_of(const Json& json) {
  const auto number = [&](const char* key) -> std::optional<double> {
    return json.at(key).is_number() ? std::optional(json.at(key).get<double>()) : std::nullopt;
  };
  CaseRecord::Event event;
  event.rover_id = json.at("rover_id").get<std::string>();
  event.sequence = json.at("sequence").get<std::int64_t>();
  event.status = json.at("status").get<std::string>();
  event.reason = json.at("reason").get<std::string>();
  event.end_s = number("end_s");
  event.charge = number("charge");
  const auto lon = number("lon_deg"), lat = number("lat_deg");
  if (lon && lat) event.place = geodetic_from_degrees(*lon, *lat);
  return event;
}

}  // namespace

std::string reason_of(const std::string& summary) {
  const Json json = Json::parse(summary);
  if (json.at("status") == "completed") return "";
  constexpr std::pair<const char*, const char*> kinds[] = {
      {"failed", "failed"}, {"incomplete", "did not end"}, {"not_started", "did not start"}};
  for (const auto& [status, what] : kinds) {
    if (const Json* event = first_with(json.at("events"), status)) return event_text(*event, what);
  }
  return "";
}

std::string to_json(const CaseRecord& record) {
  Json events = Json::array();
  for (const CaseRecord::Event& event : record.events) events.push_back(event_json(event));
  const Json json{{"case", record.number},
                  {"seed", record.seed},
                  {"values", object_of(record.values)},
                  {"status", record.status},
                  {"reason", record.reason},
                  {"gathered", object_of(record.gathered)},
                  {"events", events},
                  {"log_sha256", record.log_sha256},
                  {"sim_s", record.sim_s},
                  {"wall_s", record.wall_s},
                  {"cpu_s", record.cpu_s}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<CaseRecord> read_case_record(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    CaseRecord record;
    record.number = json.at("case").get<std::int64_t>();
    record.seed = json.at("seed").get<std::uint64_t>();
    record.values = values_in(json.at("values"));
    record.gathered = values_in(json.at("gathered"));
    for (const Json& event : json.at("events")) record.events.push_back(event_of(event));
    record.status = json.at("status").get<std::string>();
    record.reason = json.at("reason").get<std::string>();
    record.log_sha256 = json.at("log_sha256").get<std::string>();
    record.sim_s = json.at("sim_s").get<double>();
    record.wall_s = json.at("wall_s").get<double>();
    record.cpu_s = json.at("cpu_s").get<double>();
    return record;
  } catch (const Json::exception&) {
    return {};
  }
}

std::string case_name(std::int64_t number) { return fmt::format("{:06}", number); }

std::string case_folder(const std::string& study_folder, std::int64_t number) {
  return fmt::format("{}/cases/{}", study_folder, case_name(number));
}

std::string part_folder(const std::string& study_folder, std::int64_t number) {
  return case_folder(study_folder, number) + ".part";
}

std::string not_run_file(const std::string& study_folder, std::int64_t number) {
  return case_folder(study_folder, number) + ".not_run";
}

}  // namespace lsos
