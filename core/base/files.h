// Reading and writing of whole files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lsos {

// Suffix of a file's name until it is complete.
inline constexpr std::string_view part_suffix = ".part";

// Writes under another name first, then renames: a reader finds the old file or the new one, never
// half of one. Throws InputError where the place cannot be written to, otherwise OutputError with
// the reason, e.g. a full disk.
void write_file(const std::string& file, std::string_view bytes);

// Absent when it cannot be read.
std::optional<std::string> read_file(const std::string& file);

}  // namespace lsos
