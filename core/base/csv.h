// Tables of separated values, as spreadsheets and instruments write them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lsos {

struct CsvRow {
  int line = 0;                    // where it begins, from 1
  std::vector<std::string> cells;  // without blanks around them
};

struct CsvTable {
  char separator = ',';
  std::vector<CsvRow> rows;  // the first is the heading; lines without any text are left out
  // Why the text cannot be read on, and where; "" if all of it was read.
  std::string fault;
  int fault_line = 0;
};

// UTF-8, with or without a byte order mark; lines end in LF, CR LF or CR. The separator is that of
// ';', tab and ',' that the heading has most of, or the one that a first line "sep=;" names. Cells
// may stand in double quotes, in which they may hold separators, line ends, and quotes doubled.
// Lines before the heading that begin with '#' are comments.
CsvTable parse_csv(std::string_view text);

// Text as a cell of commas, quoted where RFC 4180 asks for it. Spreadsheets evaluate cells that
// begin with =, +, - or @, also in quotes: such a text gets an apostrophe in front, as a planner
// types it there and OWASP recommends ("CSV injection"). Numbers, also with a unit or as lists, are
// no formulas.
std::string csv_cell(std::string_view text);
// The text with such an apostrophe, and without it. The second undoes the first for every text.
std::string guarded_text(std::string_view text);
std::string unguarded_text(std::string_view text);

}  // namespace lsos
