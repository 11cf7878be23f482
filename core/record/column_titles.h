// What the columns of a log are called for people, and what they mean: titles that GIS tools show
// in place of the names.
#pragma once

#include <string_view>

namespace lsos {

struct ColumnTitle {
  std::string_view name;
  std::string_view title;         // with its unit: "Speed, m/s"
  std::string_view meaning = "";  // what the title does not say
};

// Of a column of a layer. Throws std::out_of_range for a name that no layer has.
ColumnTitle column_title(std::string_view layer, std::string_view name);

}  // namespace lsos
