// Titles and meanings of the log's columns, for people: GIS tools show the titles in place of the
// names.
#pragma once

#include <string_view>

namespace lsos {

struct ColumnTitle {
  std::string_view name;
  std::string_view title;         // with its unit: "Speed, m/s"
  std::string_view meaning = "";  // what the title does not say
};

// The title of a column in a layer. Throws std::out_of_range for a name that no layer has.
ColumnTitle column_title(std::string_view layer, std::string_view name);

}  // namespace lsos
