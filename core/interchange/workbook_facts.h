// What a workbook shows that GDAL does not tell of it.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lsos {

// A block of merged cells, counted from 0.
struct MergedCells {
  std::size_t row = 0, column = 0, rows = 1, columns = 1;
};

// What a cell's number format shows beside its number.
struct ShownFormat {
  bool is_span = false;  // hours beyond 24, "[h]:mm": the number counts days
  std::string unit;      // "km/h" of the format 0.0" km/h"; "": none; "%": the cell shows 100 times
                         // its number
};

struct WorkbookFacts {
  bool is_ods = false;
  bool counts_from_1904 = false;                           // dates of an XLSX file
  std::map<std::string, std::vector<MergedCells>> merged;  // by sheet
  // Formats of cells that show more than a number, by sheet and {row, column} from 0.
  std::map<std::string, std::map<std::pair<std::size_t, std::size_t>, ShownFormat>> formats;
  // Texts of ODS cells that have a comment, without it; GDAL takes both for the text.
  std::map<std::string, std::map<std::pair<std::size_t, std::size_t>, std::string>> texts;
};

}  // namespace lsos
