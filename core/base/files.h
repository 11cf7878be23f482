// Reading and writing of whole files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lsos {

// Writes a WholeFile, which see: a reader finds the old file or the new one, never half of one, and
// a link is replaced, not followed. Throws InputError where the place cannot be written to,
// otherwise OutputError with the reason, e.g. a full disk.
void write_file(const std::string& file, std::string_view bytes);
// The same, but refuses a name that is taken.
void write_new_file(const std::string& file, std::string_view bytes);

// Absent when it cannot be read.
std::optional<std::string> read_file(const std::string& file);

}  // namespace lsos
