// A folder for one test, removed with its contents at the end.
#pragma once

#include <filesystem>
#include <string>

namespace lsos::test {

class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  // Writes a file, creating the folders above it, and returns its path.
  std::string write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

// Text of a file; "" when there is none.
std::string read_text(const std::filesystem::path& file);

}  // namespace lsos::test
