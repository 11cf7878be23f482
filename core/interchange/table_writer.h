// Writes tables as spreadsheets and maps, by GDAL's drivers.
#pragma once

#include <string>
#include <vector>

#include "interchange/table.h"
#include "planet/body.h"

namespace lsos {

// The bytes of a file with these tables. `ending`: .csv (one table), .xlsx, .ods, .geojson (one
// table) or .gpkg, whose layers lie on `body`. A column is of numbers where each of its texts is a
// number in shortest form, else of texts. Throws InputError for `file` where a text is too long for
// a cell of a spreadsheet, and OutputError when GDAL cannot write it.
std::string tables_as(const std::string& ending, const std::vector<Table>& tables, const Body& body,
                      const std::string& file);

}  // namespace lsos
