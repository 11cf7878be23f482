// Words of a shell's command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lsos {

// The text as one word of a POSIX shell: as it is where it holds no character that a shell reads
// otherwise, else in single quotes.
std::string shell_word(std::string_view text);

// The words as a command, with blanks between them.
std::string shell_command(const std::vector<std::string>& words);

}  // namespace lsos
