// A table of things that may belong to a plan: a sheet of a spreadsheet, a layer of a map, the
// lines of an outline. All formats that are imported become tables first.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "plan/kml_source.h"

namespace lsos {

struct TableRow {
  int number = 0;                  // row of a sheet, feature of a layer, line of a text
  std::vector<std::string> cells;  // texts in the order of the header; may be fewer
  std::optional<SourceGeometry> geometry = {};  // of a feature on a map
};

struct Table {
  std::string file;          // for messages: "tasks.csv", "tasks.xlsx/Events", "map.geojson"
  std::string name;          // of the sheet or layer; of a file with one table, its stem
  bool has_letters = false;  // columns are told by letters: "C7"
  bool has_commas = false;   // "5,5" in it is 5.5
  int header_number = 0;     // row of the header in a sheet
  std::vector<std::string> header;
  std::vector<TableRow> rows;          // without empty ones
  bool is_geographic = true;           // places are in degrees
  std::set<std::size_t> numbers = {};  // columns of a table that is written, whose texts are
                                       // numbers, "0.020": only their values count
  std::string body = {};  // that its places lie on, by its CRS; "": it has none, or no places
};

// "A" for 0, "Z" for 25, "AA" for 26.
std::string column_letters(std::size_t index);

// Where a cell stands, or the row when it has no letters.
Place place_of_cell(const Table& table, int row, std::size_t column);

// The text of a cell without blanks around it; "" where the row is shorter.
std::string cell(const TableRow& row, std::size_t column);

}  // namespace lsos
