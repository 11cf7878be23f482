// Reading of files that others wrote, in bounded time and memory: whatever stands at the path, such
// as a device, a pipe that nobody writes into or a file of 100 GB with holes.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "base/parsed.h"

namespace lsos {

struct FileBounds {
  std::size_t bytes_max = std::size_t{256} << 20;
  bool may_be_pipe = false;  // such as /dev/stdin
  // A pipe into which nothing is written for so long is given up.
  std::chrono::milliseconds silence_max = std::chrono::seconds(60);
};

// All bytes of a regular file or, where it may be one, a pipe. Otherwise why not, which goes on
// after the file's name: "is a folder", "cannot be opened: No such file or directory", "is larger
// than 256 MiB".
Parsed<std::string> read_bounded(const std::string& file, const FileBounds& bounds = {});

// The same of a file that the user names, which may be a pipe: `<(zcat rows.csv.gz)`, /dev/stdin.
// Throws InputError with the reason.
std::string read_named_file(const std::string& file);

inline constexpr const char* is_folder = "is a folder";
// What stands at a path that is no regular file: `is_folder`, "is a pipe"; "" where it is one, or
// where there is nothing.
std::string other_than_file(const std::string& path);
// "is larger than 64 MiB".
std::string too_large(std::size_t bytes_max);
// The same, "" for a file that is not larger, or for none.
std::string larger_than(const std::string& path, std::size_t bytes_max);

}  // namespace lsos
