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

// Files with one of the extensions (".h", ...) below the folders of the repository that hold
// source code, in order of path.
std::vector<SourceFile> source_files(const std::vector<std::string>& extensions);

std::filesystem::path repository();
// Without its line ends; throws std::runtime_error when it cannot be read.
std::vector<std::string> read_lines(const std::filesystem::path& file);

}  // namespace lsos::test
