// What a text of Lua may take to compile. Lua's parser is in general as fast as the text is long,
// but walks a list for each `and`, `or`, `elseif` and jump, so that its time grows with the square
// of their number. The text is looked through for them before the parser sees it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace lsos {

inline constexpr std::size_t source_bytes_max = std::size_t{1} << 20;
// 'and' and 'or' of one expression, and 'elseif' of one 'if': a thousand take 1 ms.
inline constexpr int terms_max = 1000;
// 'break', 'goto' and labels of one text.
inline constexpr int jumps_max = 2000;

struct SourceFault {
  int line = 0;
  std::string what;
};

// The first place at which the text exceeds the numbers above; absent for none. A text that is not
// Lua may be without fault here, and be refused by the parser where it goes wrong.
std::optional<SourceFault> source_fault(std::string_view source);

}  // namespace lsos
