// Opens the files that a plan is imported from, whatever their format.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "interchange/table.h"
#include "plan/declaration.h"

namespace lsos {

// Endings of the names of files that can be imported, for messages and help.
inline constexpr const char* import_formats =
    "a spreadsheet (.csv, .tsv, .xlsx, .ods), a map (.kml, .kmz, .geojson, .gpkg, .shp, .gpx), an "
    "xGDS plan (.json) or an outline (.txt)";

// The tables of a file. Its format is that of its name's ending; no other file is opened but those
// that belong to it (of a Shapefile the files of its name). `left_out` receives what it has that no
// table can hold. Throws InputError when the file cannot be read or has another format.
std::vector<Table> read_tables(const std::string& file, const Declarations& declarations,
                               std::vector<std::string>& left_out);

// Reports files that are given twice, or whose bytes are those of another: their events would stand
// twice in the plan. Files that cannot be read are left to read_tables().
void report_equal_files(const std::vector<std::string>& files, Faults& faults);

}  // namespace lsos
