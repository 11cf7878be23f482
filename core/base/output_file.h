// Checks of the names of output files: no file with other content is replaced.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace lsos {

// Adds a fault where the name has none of the endings (".tif"), its folder does not exist or cannot
// be written, or it is one of the files that the command reads.
void check_output(const std::string& option, const std::string& file,
                  const std::vector<std::string>& endings, const std::vector<std::string>& inputs,
                  Faults& faults);

// Adds a fault where the name is taken, be it by a link that leads nowhere. `advice`: "--force
// replaces it".
void check_free(const std::string& option, const std::string& file, const std::string& advice,
                Faults& faults);

// The folder of `name` as the program chooses it, below `folder`, which the user chose: "" where
// the user chose none. Throws InputError where a folder on the way is a link: in a folder that came
// from elsewhere it may lead anywhere.
void refuse_links(const std::string& folder, const std::string& name);

// Throws std::runtime_error where the file exists, is not empty and does not begin with `mark`.
// Scripts choose these names, and they are tried out beside plans and notes.
void check_replaceable(const std::string& file, std::string_view mark);

}  // namespace lsos
