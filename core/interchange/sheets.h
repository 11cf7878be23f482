// Reads spreadsheets: CSV, XLSX and ODS.
#pragma once

#include <string>
#include <vector>

#include "interchange/table.h"

namespace lsos {

// Greatest number of cells of a file, and of bytes that an XLSX or ODS file unpacks to.
inline constexpr std::size_t cells_max = 20'000'000;
inline constexpr std::size_t sheet_bytes_max = std::size_t{256} << 20;

// The tables of a spreadsheet, one a sheet, without sheets and rows that are empty. The first row
// with text is the header. A merged cell has its text in each cell that it covers. Formulas have
// the values that were saved with them. Dates are "2026/07/03 08:00:00". Throws InputError for a
// file that cannot be read, is damaged or too large.
std::vector<Table> read_csv(const std::string& bytes, const std::string& file);
std::vector<Table> read_workbook(const std::string& bytes, const std::string& file);

// CSV bytes as UTF-8: of UTF-16 with a byte order mark, and windows-1252 where they are not UTF-8.
std::string csv_text(const std::string& bytes, const std::string& file);

}  // namespace lsos
