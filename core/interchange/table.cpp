#include "interchange/table.h"

#include <algorithm>

#include "base/text.h"

namespace lsos {

std::string column_letters(std::size_t index) {
  constexpr std::size_t letters = 26;
  std::string name;
  for (std::size_t left = index + 1; left > 0; left = (left - 1) / letters) {
    name.insert(name.begin(), static_cast<char>('A' + (left - 1) % letters));
  }
  return name;
}

Place place_of_cell(const Table& table, int row, std::size_t column) {
  return {table.file, row, table.has_letters ? column_letters(column) : ""};
}

std::string cell(const TableRow& row, std::size_t column) {
  return column < row.cells.size() ? std::string(trimmed(row.cells[column])) : "";
}

}  // namespace lsos
