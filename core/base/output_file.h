// Names of files that commands write: none that holds something else is replaced.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace lsos {

// A fault where the name has none of the endings (".tif"), its folder is not there or may not be
// written, or it is one of the files that the command reads.
void check_output(const std::string& option, const std::string& file,
                  const std::vector<std::string>& endings, const std::vector<std::string>& inputs,
                  Faults& faults);

// Throws std::runtime_error where something is there that is neither empty nor begins with `mark`:
// what is written in its place is asked for by scripts, and those are tried out beside plans and
// notes.
void check_replaceable(const std::string& file, std::string_view mark);

}  // namespace lsos
