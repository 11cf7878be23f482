#include "lua/edit/imported_files.h"

#include <algorithm>

#include "interchange/columns.h"
#include "interchange/header_row.h"
#include "interchange/source_tables.h"

namespace lsos {

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
    } else if (lacks_place) {
      told.error(fault.place, fault.what + "; Place, Lon and Lat, or WKT say where it is");
    } else {
      told.add({fault});
    }
  }
  return told;
}

}  // namespace lsos
