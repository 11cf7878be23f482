// Texts in UTF-8.
#pragma once

#include <string_view>

namespace lsos {

// Whether all of it is UTF-8: shortest forms, no surrogates, at most U+10FFFF.
bool is_utf8(std::string_view text);

}  // namespace lsos
