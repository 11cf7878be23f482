// The repository's own source files, read for checks of the tree itself.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lsos::test {

struct SourceFile {
  std::filesystem::path path;  // relative to the repository
  std::vector<std::string> lines;
};

// Files with one of the extensions (".h", ...) in the repository's folders of source code, in order
// of path.
std::vector<SourceFile> source_files(const std::vector<std::string>& extensions);

std::filesystem::path repository();
// Shipped plans, in order of name: those that run in a minute or so, and those of weeks, which take
// many.
std::vector<std::filesystem::path> shipped_plans();
std::vector<std::filesystem::path> long_plans();
// Lines without their line ends. Throws std::runtime_error when the file cannot be read.
std::vector<std::string> read_lines(const std::filesystem::path& file);

}  // namespace lsos::test
