// Texts in UTF-8.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lsos {

// Length of the well-formed UTF-8 character at the start of `text`, which is not empty; 0: the
// first byte begins none. Well-formed are shortest forms, no surrogates, at most U+10FFFF.
std::size_t utf8_length(std::string_view text);

// Whether all of it is UTF-8.
bool is_utf8(std::string_view text);

// Whether a name can be shown in a line: UTF-8 without control characters.
bool is_name(std::string_view text);

// The first bytes of a text, at most `bytes_max`, which end with a whole character.
std::string beginning(std::string_view text, std::size_t bytes_max);

// The text with each byte that is no UTF-8, and each zero byte, as U+FFFD.
std::string utf8_text(std::string_view text);

}  // namespace lsos
