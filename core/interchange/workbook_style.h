// How an XLSX file that GDAL has written looks when it is opened: GDAL sets neither widths of
// columns nor styles.
#pragma once

#include <string>
#include <vector>

#include "interchange/table.h"

namespace lsos {

// The file with columns as wide as their texts, and the header of each sheet bold and kept in view.
// `tables`: its sheets, in order. A file without the parts that GDAL 3 writes (styles, workbook, a
// sheet for each table), or without their lists, stays as it is.
std::string styled_workbook(const std::string& xlsx, const std::vector<Table>& tables);

}  // namespace lsos
