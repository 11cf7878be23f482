#include "lua/study/gather_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "lua/runtime/reader.h"
#include "product/study/study_columns.h"
#include "record/quantities.h"

namespace lsos {

namespace {

using Kind = StudyColumn::Kind;

char ascii_lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// The SI unit of a unit's kind, as "m/s" of "km/h"; "" for numbers without one.
std::string si_unit_of_kind(const Unit* unit) {
  if (unit == nullptr || unit->kind == "fraction") return "";
  for (const Unit& each : all_units()) {
    if (each.kind == unit->kind && each.si_factor == 1) return std::string(each.symbol);
  }
  return "";
}

std::string si_unit(const Parameter& parameter) {
  const FieldDeclaration* field = parameter.style.field;
  if (field == nullptr) return si_unit_of(parameter.address.name);
  const bool is_time = field->kind == FieldKind::duration || field->kind == FieldKind::moment;
  return is_time ? "s" : si_unit_of_kind(parameter.style.unit);
}

ColumnType type_of(const Draw::Value& value) {
  if (std::holds_alternative<std::string>(value)) return ColumnType::text;
  return std::holds_alternative<double>(value) ? ColumnType::real : ColumnType::integer;
}

void add_columns(const Parameter& parameter, std::vector<StudyColumn>& columns) {
  const std::string how = fmt::format("varies: {}", to_string(parameter.variation.form));
  if (parameter.is_place()) {
    columns.push_back({parameter.name() + ".east_m", Kind::parameter, parameter.name(), "m",
                       "How far east its place is moved.", ColumnType::real});
    columns.push_back({parameter.name() + ".north_m", Kind::parameter, parameter.name(), "m",
                       "How far north its place is moved.", ColumnType::real});
    return;
  }
  const FieldDeclaration* field = parameter.style.field;
  const Draw any = draw(parameter, {{parameter.name(), 0.0}});
  columns.push_back({parameter.name(), Kind::parameter, parameter.name(), si_unit(parameter),
                     field == nullptr ? "Key of a script; " + how : field->doc + "; " + how,
                     type_of(any.values.front().second)});
}

// The last words of a path in summary.json whose values are texts.
constexpr std::array texts{"status", "reason", "type", "label", "log_sha256", "plan", "rover_id"};

StudyColumn column_of(const Gathering& gathering) {
  StudyColumn column{gathering.name, Kind::gathered, gathering.path, "", "", ColumnType::real};
  switch (gathering.take) {
    case Gathering::Take::summary: {
      const std::string last = gathering.path.substr(gathering.path.rfind('.') + 1);
      if (std::ranges::count(texts, last) > 0) column.type = ColumnType::text;
      column.unit = si_unit_of(last);
      column.sentence = fmt::format("{} of summary.json.", gathering.path);
      return column;
    }
    case Gathering::Take::at_start:
    case Gathering::Take::at_end:
      column.address = gathering.event;
      column.sentence =
          fmt::format("{} when {} {}.", gathering.quantity, gathering.event,
                      gathering.take == Gathering::Take::at_start ? "starts" : "ends");
      break;
    case Gathering::Take::least:
    case Gathering::Take::greatest:
      column.address = gathering.rover;
      column.sentence = fmt::format("{} {} of {}.",
                                    gathering.take == Gathering::Take::least ? "Least" : "Greatest",
                                    gathering.quantity, gathering.rover);
      break;
    case Gathering::Take::share:
      column.address = gathering.rover;
      column.sentence =
          fmt::format("Share of the time of {} with {}.", gathering.rover, gathering.condition);
      return column;
  }
  column.unit = si_unit_of(gathering.quantity);
  return column;
}

}  // namespace

GatherRequest gather_request(const StudyFiles& files, const std::string& folder) {
  const Plan& plan = files.base.plan;
  GatherRequest request;
  request.folder = folder;
  request.crs = std::string(plan.mission.planet->crs);
  request.cases = files.cases;
  for (const PlanRover& rover : plan.rovers) request.rovers.push_back(rover.id);
  for (const PlanEvent& event : plan.events) {
    PlannedEvent planned{event.rover_id, event.sequence, event.type, event.label, std::nullopt};
    if (!event.geometry.points.empty()) planned.place = event.geometry.points.back();
    request.events.push_back(std::move(planned));
  }
  for (const Parameter& parameter : files.parameters) {
    add_columns(parameter, request.parameters);
  }
  for (const Gathering& gathering : files.study.gathered) {
    request.gathered.push_back(column_of(gathering));
  }
  return request;
}

void check_columns(const StudyFiles& files) {
  const GatherRequest request = gather_request(files, "");
  std::map<std::string, const StudyColumn*> known;
  Faults faults;
  const std::vector<StudyColumn> columns =
      study_columns(request.parameters, request.gathered, request.rovers);
  for (const StudyColumn& column : columns) {
    std::string name = column.name;
    std::ranges::transform(name, name.begin(), ascii_lower);
    const auto [first, is_new] = known.emplace(name, &column);
    if (is_new) continue;
    const auto gathering = std::ranges::find(files.study.gathered, column.name, &Gathering::name);
    const bool is_gathered = column.kind == Kind::gathered;
    faults.error(is_gathered ? gathering->place : files.study.place,
                 fmt::format("{}: '{}' would be the column '{}' of study.gpkg, whose names have no "
                             "case: {}",
                             is_gathered ? "gather" : "study", column.name, first->second->name,
                             is_gathered ? "'name' says another"
                                         : "rovers whose names differ in more are wanted"));
    if (!is_gathered) break;  // all numbers of that rover
  }
  faults.throw_if_errors();
}

}  // namespace lsos
