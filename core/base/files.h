// Whole files, read and written at once.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lsos {

// Ending of the name that a file has until it is complete.
inline constexpr std::string_view part_suffix = ".part";

// Under another name first, then renamed: a reader finds the old file or the new one, never half of
// one. Throws InputError where the place is not one to write to, OutputError with the reason when
// the disk is full.
void write_file(const std::string& file, std::string_view bytes);

// Absent when it cannot be read.
std::optional<std::string> read_file(const std::string& file);

}  // namespace lsos
