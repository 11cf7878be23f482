#include "system/source_files.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace lsos::test {

namespace fs = std::filesystem;

fs::path repository() { return LSOS_SOURCE_DIR; }

std::vector<std::string> read_lines(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<SourceFile> source_files(const std::vector<std::string>& extensions) {
  std::vector<SourceFile> files;
  for (const char* folder :
       {"core", "lua", "events", "rovers", "terrain", "lib", "tests", "bench"}) {
    if (!fs::exists(repository() / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(repository() / folder)) {
      const std::string extension = entry.path().extension().string();
      if (!entry.is_regular_file() || std::ranges::count(extensions, extension) == 0) continue;
      files.push_back({fs::relative(entry.path(), repository()), read_lines(entry.path())});
    }
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

std::vector<std::filesystem::path> long_plans() {
  return {repository() / "plans/drats.kml", repository() / "plans/lunar_campaign.kml"};
}

std::vector<std::filesystem::path> shipped_plans() {
  std::vector<std::filesystem::path> plans;
  const std::vector<std::filesystem::path> of_weeks = long_plans();
  for (const auto& entry : std::filesystem::directory_iterator(repository() / "plans")) {
    const bool is_long = std::ranges::find(of_weeks, entry.path()) != of_weeks.end();
    if (entry.path().extension() == ".kml" && !is_long) plans.push_back(entry.path());
  }
  std::ranges::sort(plans);
  return plans;
}

}  // namespace lsos::test
