// Reading and writing of whole files.
#pragma once

#include <cstdint>
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

// Which file it is that a name leads to: another one of the same name is not equal.
struct FileIdentity {
  std::uint64_t device = 0, number = 0;

  bool operator==(const FileIdentity&) const = default;
};
// Absent where there is none.
std::optional<FileIdentity> identity_of(const std::string& file);

// The bytes of a regular file that the program itself keeps; what the user names is for
// read_named_file() of bounded_file.h. Absent when it cannot be read.
std::optional<std::string> read_file(const std::string& file);

}  // namespace lsos
