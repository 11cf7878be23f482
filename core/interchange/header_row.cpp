#include "interchange/header_row.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "interchange/columns.h"

namespace lsos {

namespace {

bool is_comment(const TableRow& row) {
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const std::string text = cell(row, i);
    if (!text.empty()) return text.front() == '#';
  }
  return false;
}

}  // namespace

std::string find_header(Table& table, const Declarations& declarations) {
  if (!table.has_letters) return "";
  constexpr std::size_t rows_tried = 10, headers_least = 2;
  std::string note;
  const std::size_t known = known_headers(table.header, declarations);
  for (std::size_t i = 0; known < headers_least && i < std::min(rows_tried, table.rows.size());
       ++i) {
    TableRow& row = table.rows[i];
    if (known_headers(row.cells, declarations) < headers_least) continue;
    table.header = std::move(row.cells);
    table.header_number = row.number;
    note = fmt::format("{}: the header is row {}; the rows above it are left out", table.file,
                       row.number);
    table.rows.erase(table.rows.begin(), table.rows.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    break;
  }
  std::erase_if(table.rows, is_comment);
  return note;
}

}  // namespace lsos
