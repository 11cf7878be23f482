// How an XLSX file that GDAL has written looks when it is opened: GDAL sets neither widths of
// columns nor styles.
#pragma once

#include <string>
#include <vector>

#include "interchange/table.h"

namespace lsos {

// The file with columns as wide as their texts, and the header of each sheet bold and kept in view.
// `tables`: its sheets, in order. What is not written as GDAL 3 does stays as it is.
std::string styled_workbook(std::string xlsx, const std::vector<Table>& tables);

}  // namespace lsos
