#include "interchange/plan_tables.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "base/quantity.h"
#include "interchange/columns.h"
#include "interchange/sheet_tables.h"
#include "interchange/thing_fields.h"
#include "plan/classify.h"

namespace lsos {

namespace {

SourcePlacemark as_thing(const PlanPlacemark& ours) {
  SourcePlacemark thing = *ours.placemark;
  thing.plain_data.clear();
  thing.data = {ours.data};
  std::erase_if(thing.data.front().fields,
                [](const SourceField& field) { return field.text.empty(); });
  return thing;
}

// Fields of the NAMEs in the order of their declarations, each once.
std::vector<std::string> declared_fields(const std::set<std::string>& names,
                                         const Declarations& declarations) {
  std::vector<std::string> fields;
  for (const std::string& name : names) {
    for (const auto& list : fields_of(name, declarations)) {
      for (const FieldDeclaration& field : list) {
        if (std::ranges::find(fields, field.name) == fields.end()) fields.push_back(field.name);
      }
    }
  }
  return fields;
}

// The header of a table of these things: only columns that have a text.
std::vector<std::string> header_of(const std::vector<const SourcePlacemark*>& things,
                                   const Declarations& declarations) {
  std::set<std::string> types, filled;
  bool has_name = false, has_description = false;
  for (const SourcePlacemark* thing : things) {
    types.insert(thing->data.front().schema);
    for (const SourceField& field : thing->data.front().fields) filled.insert(field.name);
    has_name |= !thing->name.empty();
    has_description |= !thing->description.empty();
  }
  // What identifies a row comes first.
  std::vector<std::string> header;
  for (const char* first : {"RoverId", "Sequence"}) {
    if (filled.contains(first)) header.emplace_back(first);
  }
  header.emplace_back(column::type);
  if (has_name) header.emplace_back(column::name);
  if (filled.contains("StartTime") && !types.contains("MissionInfo")) {
    header.emplace_back("StartTime");
  }
  for (const std::string& field : declared_fields(types, declarations)) {
    const bool is_in = std::ranges::find(header, field) != header.end();
    if (!is_in && filled.contains(field)) header.push_back(field);
  }
  if (has_description) header.emplace_back(column::description);
  return header;
}

std::string cell_of(const SourcePlacemark& thing, const std::string& name) {
  if (name == column::type) return thing.data.front().schema;
  if (name == column::name) return thing.name;
  if (name == column::description) return thing.description;
  const std::string* text = thing_field(thing, name);
  return text == nullptr ? "" : *text;
}

Table table_of(const std::string& name, const std::vector<const SourcePlacemark*>& things,
               const Declarations& declarations) {
  Table table;
  table.name = name;
  table.header = header_of(things, declarations);
  for (const SourcePlacemark* thing : things) {
    TableRow row{static_cast<int>(table.rows.size()) + 1, {}};
    for (const std::string& column : table.header) row.cells.push_back(cell_of(*thing, column));
    if (!thing->geometries.empty()) row.geometry = thing->geometries.front();
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string table_name(const std::string& type, TableDivision division) {
  return division == TableDivision::by_type ? type : "plan";
}

}  // namespace

KmlSource plan_things(const KmlSource& source, const Declarations& declarations) {
  Faults ignored;  // the plan has been read without any
  const Classified ours = classify(source, declarations, ignored);
  KmlSource things{source.file, {}};
  for (const auto* list : {&ours.missions, &ours.rovers, &ours.assets, &ours.events}) {
    const std::size_t first = things.placemarks.size();
    for (const PlanPlacemark& each : *list) things.placemarks.push_back(as_thing(each));
    if (list != &ours.events) continue;
    const auto order = [](const SourcePlacemark& thing) {
      const std::string *rover = thing_field(thing, "RoverId"),
                        *number = thing_field(thing, "Sequence");
      const auto sequence = number == nullptr ? Parsed<std::int64_t>{} : parse_integer(*number);
      return std::tuple(rover == nullptr ? std::string() : *rover, sequence.value.value_or(0));
    };
    std::ranges::stable_sort(things.placemarks.begin() + static_cast<std::ptrdiff_t>(first),
                             things.placemarks.end(), {}, order);
  }
  return things;
}

std::vector<Table> plan_tables(const KmlSource& things, const Declarations& declarations,
                               TableDivision division, bool has_geometries,
                               const std::vector<Landmark>& landmarks) {
  if (!has_geometries && division != TableDivision::by_type) {
    return sheet_tables(things, declarations, landmarks, division == TableDivision::none);
  }
  std::vector<std::string> names;
  std::map<std::string, std::vector<const SourcePlacemark*>> parts;
  for (const SourcePlacemark& thing : things.placemarks) {
    const std::string name = table_name(thing.data.front().schema, division);
    if (!parts.contains(name)) names.push_back(name);
    parts[name].push_back(&thing);
  }
  std::vector<Table> tables;
  for (const std::string& name : names) {
    tables.push_back(table_of(name, parts[name], declarations));
  }
  return tables;
}

}  // namespace lsos
