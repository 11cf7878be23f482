#include "product/comparison/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lsos {

std::string text_table(const std::vector<Cells>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  // The width of a text in characters, not bytes: "30°".
  const auto width = [](const std::string& text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
  };
  for (const Cells& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], width(row[k]));
  }
  std::string text;
  for (const Cells& row : rows) {
    std::string line = "  " + row[0] + std::string(widths[0] - width(row[0]), ' ');
    for (std::size_t k = 1; k < row.size(); ++k) {
      line += std::string(2 + widths[k] - width(row[k]), ' ') + row[k];
    }
    text += line + "\n";
  }
  return text;
}

std::string clock_text(std::optional<SimTime> time) {
  if (!time) return "-";
  const std::int64_t tenths = std::llround(seconds(*time) * 10), whole_s = tenths / 10;
  std::string text = fmt::format("{}:{:02}:{:02}", whole_s / 3600, whole_s / 60 % 60, whole_s % 60);
  if (tenths % 10 != 0) text += fmt::format(".{}", tenths % 10);
  return text;
}

}  // namespace lsos
