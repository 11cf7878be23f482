#include "product/study/study_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;
using Kind = StudyColumn::Kind;

// The numbers that a summary has of each rover.
struct RoverNumber {
  const char *name, *unit, *sentence;
};
constexpr RoverNumber rover_numbers[] = {
    {"distance_m", "m", "Distance driven along the ground."},
    {"duration_s", "s", "Time from the start to the end of its last event."},
    {"drive_s", "s", "Time spent faster than 1 mm/s."},
    {"energy_start_j", "J", "Energy in the battery at the start."},
    {"energy_end_j", "J", "Energy in the battery at the end."},
    {"energy_used_j", "J", "Energy used by loads, driving and losses."},
    {"solar_j", "J", "Energy from its panels."},
    {"external_j", "J", "Energy from outside, with levels that were set."},
    {"elevation_gain_m", "m", "Sum of rises, with a hysteresis of 0.5 m."},
    {"max_slope_rad", "rad", "Steepest slope under its wheels."},
    {"max_slip", "", "Greatest mean slip over a second of driving."},
    {"p95_slip", "", "Slip that it did not exceed in 95 % of its driving."}};

ColumnValue text_or_none(const std::string& text) {
  return text.empty() ? ColumnValue{} : ColumnValue{text};
}

ColumnValue number_or_none(double number) {
  return std::isfinite(number) ? ColumnValue{number} : ColumnValue{};
}

// A value as the column's type has it; none where it is of another kind.
ColumnValue cell(const Draw::Value& value, ColumnType type) {
  const auto* number = std::get_if<double>(&value);
  const auto* whole = std::get_if<std::int64_t>(&value);
  const auto* flag = std::get_if<bool>(&value);
  const auto* text = std::get_if<std::string>(&value);
  switch (type) {
    case ColumnType::real:
      if (number != nullptr) return number_or_none(*number);
      if (whole != nullptr) return static_cast<double>(*whole);
      if (flag != nullptr) return *flag ? 1.0 : 0.0;
      return {};
    case ColumnType::integer:
      if (whole != nullptr) return *whole;
      if (flag != nullptr) return std::int64_t{*flag};
      return {};
    case ColumnType::text:
    case ColumnType::utc:
      break;
  }
  if (text != nullptr) return text_or_none(*text);
  if (number != nullptr) return fmt::format("{}", *number);
  if (whole != nullptr) return fmt::format("{}", *whole);
  return std::string(*flag ? "true" : "false");
}

using NamedCells = std::map<std::string, ColumnValue>;

void add_rover_numbers(const std::string& summary, const std::vector<std::string>& rovers,
                       NamedCells& cells) {
  const Json json = Json::parse(summary, nullptr, false);
  if (!json.is_object() || !json.contains("rovers")) return;
  for (const std::string& id : rovers) {
    if (!json["rovers"].contains(id)) continue;
    for (const RoverNumber& each : rover_numbers) {
      const Json& rover = json["rovers"][id];
      if (!rover.contains(each.name) || !rover[each.name].is_number()) continue;
      cells[fmt::format("{}_{}", id, each.name)] = rover[each.name].get<double>();
    }
  }
}

}  // namespace

const char* to_string(StudyColumn::Kind kind) {
  switch (kind) {
    case Kind::parameter:
      return "parameter";
    case Kind::summary:
      return "summary";
    case Kind::gathered:
      return "gathered";
    case Kind::machine:
      break;
  }
  return "machine";
}

std::vector<StudyColumn> study_columns(const std::vector<StudyColumn>& parameters,
                                       const std::vector<StudyColumn>& gathered,
                                       const std::vector<std::string>& rovers) {
  std::vector<StudyColumn> columns{
      {"case", Kind::summary, "", "", "Number of the case, from 1.", ColumnType::integer},
      {"seed", Kind::summary, "MissionInfo.Seed", "", "Seed of its plan.", ColumnType::integer}};
  columns.insert(columns.end(), parameters.begin(), parameters.end());
  columns.push_back({"status", Kind::summary, "status", "",
                     "What became of the mission: completed, failed, incomplete, or not_run.",
                     ColumnType::text});
  columns.push_back({"reason", Kind::summary, "", "",
                     "Why it did not complete: the first event that failed or did not end.",
                     ColumnType::text});
  for (const std::string& id : rovers) {
    for (const RoverNumber& each : rover_numbers) {
      columns.push_back({fmt::format("{}_{}", id, each.name), Kind::summary,
                         fmt::format("rovers.{}.{}", id, each.name), each.unit, each.sentence,
                         ColumnType::real});
    }
  }
  columns.insert(columns.end(), gathered.begin(), gathered.end());
  columns.push_back({"sim_s", Kind::summary, "sim_s", "s", "Time simulated.", ColumnType::real});
  columns.push_back({"log_sha256", Kind::summary, "log_sha256", "", "Digest of the case's log.",
                     ColumnType::text});
  columns.push_back(
      {"wall_s", Kind::machine, "", "s", "Time that the case took to run.", ColumnType::real});
  columns.push_back({"cpu_s", Kind::machine, "", "s",
                     "Processor time of the process that ended the case.", ColumnType::real});
  columns.push_back({"real_time_factor", Kind::machine, "", "", "Time simulated by time taken.",
                     ColumnType::real});
  return columns;
}

std::vector<ColumnValue> row_of_case(const std::vector<StudyColumn>& columns,
                                     const CaseRecord& record, const std::string& summary,
                                     const std::vector<std::string>& rovers) {
  NamedCells cells;
  add_rover_numbers(summary, rovers, cells);
  if (record.status != not_run_status) {
    cells["sim_s"] = number_or_none(record.sim_s);
    cells["wall_s"] = number_or_none(record.wall_s);
    cells["cpu_s"] = number_or_none(record.cpu_s);
    cells["real_time_factor"] = number_or_none(record.sim_s / record.wall_s);
  }
  cells["case"] = record.number;
  cells["seed"] = static_cast<std::int64_t>(record.seed);
  cells["status"] = text_or_none(record.status);
  cells["reason"] = text_or_none(record.reason);
  cells["log_sha256"] = text_or_none(record.log_sha256);
  const auto value_in = [](const CaseRecord::Values& values, const StudyColumn& column) {
    const auto found =
        std::ranges::find(values, column.name, &CaseRecord::Values::value_type::first);
    return found == values.end() ? ColumnValue{} : cell(found->second, column.type);
  };
  std::vector<ColumnValue> row;
  for (const StudyColumn& column : columns) {
    if (column.kind == Kind::parameter) {
      row.push_back(value_in(record.values, column));
    } else if (column.kind == Kind::gathered) {
      row.push_back(value_in(record.gathered, column));
    } else {
      row.push_back(cells[column.name]);
    }
  }
  return row;
}

}  // namespace lsos
