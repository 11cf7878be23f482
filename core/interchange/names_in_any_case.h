// Names that people write in another case of letters.
#pragma once

#include <string>
#include <vector>

namespace lsos {

// The name of `names` that a text is: itself, else the only one that differs from it in case alone.
// "" where there is none, or several.
std::string name_in_any_case(const std::string& text, const std::vector<std::string>& names);

}  // namespace lsos
