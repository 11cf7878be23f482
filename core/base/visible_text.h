// Text of plans, files and scripts as a terminal may show it.
#pragma once

#include <string>
#include <string_view>

namespace lsos {

// The text with what a terminal would obey, or show as nothing, written out: control characters
// but line feeds and tabs, marks that change the direction of writing, and characters without
// width. Each becomes \uXXXX, which in a JSON string is the same character: JSON stays the same
// document. A byte that is no UTF-8 becomes \xXX.
std::string visible_text(std::string_view text);

// The text with each character that XML 1.0 does not allow, and each byte that is no UTF-8, as
// U+FFFD. Markup is not escaped.
std::string xml_text(std::string_view text);

// The text in one line: line ends and other control characters of ASCII as blanks.
std::string one_line(std::string_view text);
bool has_control_characters(std::string_view text);

}  // namespace lsos
