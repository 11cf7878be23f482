#include "lua/edit/imported_files.h"

#include <algorithm>
#include <regex>

#include "base/console.h"
#include "interchange/columns.h"
#include "interchange/header_row.h"
#include "interchange/source_tables.h"

namespace lsos {

namespace {

// Whether a reference to an event is a date, "there is no event '2026/01/20'".
bool names_date(const std::string& what) {
  static const std::regex date(R"(there is no event '\d{4}[-/]\d\d[-/]\d\d)");
  return std::regex_search(what, date);
}

}  // namespace

std::vector<Table> read_all_tables(const std::vector<std::string>& files,
                                   const Declarations& declarations,
                                   std::vector<std::string>& left_out) {
  std::vector<Table> tables;
  Faults faults;
  report_equal_files(files, faults);
  faults.throw_if_errors();
  for (const std::string& file : files) {
    try {
      for (Table& table : read_tables(file, declarations, left_out)) {
        tables.push_back(std::move(table));
      }
    } catch (const InputError& error) {
      faults.add(error.faults());
    }
  }
  faults.throw_if_errors();  // a place that is missing would only follow from these
  return tables;
}

std::map<std::string, SheetColumns> sheet_columns(const std::vector<Table>& tables,
                                                  const Declarations& declarations) {
  std::map<std::string, SheetColumns> all;
  for (Table table : tables) {
    Faults told;  // by import_tables(), as notes are
    find_header(table, declarations);
    SheetColumns& columns = all[table.file];
    const Columns said(table, declarations, told);
    for (const auto& [name, column] : said.all()) {
      columns.names.insert(name);
    }
    columns.has_places = std::ranges::any_of(
        table.rows, [](const TableRow& row) { return row.geometry.has_value(); });
    for (const char* name : {column::place, column::lon, column::lat, column::wkt}) {
      columns.has_places |= columns.names.contains(name);
    }
  }
  return all;
}

std::set<ThingKey::Kind> kinds_of_sheets(const std::vector<Table>& tables,
                                         const Declarations& declarations) {
  std::set<ThingKey::Kind> kinds;
  for (const Table& table : tables) {
    const std::string type = type_of_sheet(table, declarations);
    if (type == "Rover") kinds.insert(ThingKey::Kind::rover);
    if (type == "Asset") kinds.insert(ThingKey::Kind::asset);
  }
  return kinds;
}

Faults with_plan_faults(const Faults& of_cells, const Faults& of_plan) {
  Faults all = of_cells;
  std::set<Place> known;
  std::set<std::string> without_sequence;  // files of which that is told
  for (const Fault& fault : of_cells.sorted()) {
    if (fault.what.starts_with("Sequence is empty")) without_sequence.insert(fault.place.file);
    const bool is_cell = fault.severity == Severity::error && !fault.place.column.empty();
    if (is_cell) known.insert(fault.place);
  }
  for (const Fault& fault : of_plan.sorted()) {
    const bool lacks_sequence = fault.what.find(": Sequence is missing; ") != std::string::npos;
    const bool is_told = known.contains(fault.place) ||
                         (lacks_sequence && without_sequence.contains(fault.place.file));
    if (!is_told) all.add({fault});
  }
  return all;
}

void tell_left_out(const Faults& faults, const std::vector<std::string>& left_out) {
  if (!faults.has_errors()) return;
  for (const std::string& line : left_out) print_message("left out: {}\n", line);
}

Faults in_words_for_sheets(const Faults& faults) {
  Faults told;
  for (const Fault& fault : faults.sorted()) {
    const bool lacks_mission = fault.what.starts_with("has no MissionInfo");
    const bool lacks_place = fault.what.find(": has no geometry; ") != std::string::npos;
    const bool lacks_rover = fault.what.starts_with("has no Rover");
    if (lacks_mission) {
      told.error({},
                 "no file says the mission: a row of Type MissionInfo with Planet, StartTime and "
                 "Terrain is wanted, or a line 'Mission: Planet Moon, StartTime ..., Terrain "
                 "...' in an outline");
    } else if (lacks_rover) {
      told.error({},
                 "no file has a rover: a row of Type Rover with RoverId, RoverType and a place is "
                 "wanted, or a line 'Rover ID: TYPE at PLACE' in an outline");
    } else if (names_date(fault.what)) {
      told.error(fault.place, fault.what +
                                  "; spreadsheets make a date of a text such as 1/20: the cell is "
                                  "to be formatted as text before it is written");
    } else if (lacks_place) {
      told.error(fault.place, fault.what + "; Place, Lon and Lat, or WKT say where it is");
    } else {
      told.add({fault});
    }
  }
  return told;
}

}  // namespace lsos
