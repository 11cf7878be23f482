// Tables of text in columns.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/sim_time.h"

namespace lsos {

using Cells = std::vector<std::string>;

// Rows of as many cells each, indented. The first column stands to the left, the others to the
// right.
std::string text_table(const std::vector<Cells>& rows);

// "1:02:03", with the tenth of a second that runs are logged in where it is not 0; "-" for none.
std::string clock_text(std::optional<SimTime> time);

}  // namespace lsos
