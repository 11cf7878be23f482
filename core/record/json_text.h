// Texts in JSON that come from a file which anybody may have written.
#pragma once

#include <string_view>

namespace lsos {

// Whether the text is one JSON object, and not nested so deep that what reads or writes it runs out
// of stack.
bool is_json_object(std::string_view text);

}  // namespace lsos
