#include "lua/host/script_folders.h"

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

namespace lsos {

namespace fs = std::filesystem;

namespace {

// What a folder has in common with all other names of it; absent where there is none.
std::optional<std::pair<dev_t, ino_t>> identity(const std::string& folder) {
  struct stat status {};
  if (stat(folder.c_str(), &status) != 0) return {};
  return std::pair(status.st_dev, status.st_ino);
}

}  // namespace

std::vector<ScriptFolder> script_folders(const std::string& plan_file, const std::string& lsos_path,
                                         const std::string& shipped_folder) {
  std::vector<ScriptFolder> folders;
  std::set<std::pair<dev_t, ino_t>> known;
  const auto shipped = identity(shipped_folder);
  // A folder that occurs twice counts at its first place.
  const auto add = [&](const std::string& folder, const std::string& shown) {
    const auto own = identity(folder);
    if (own && !known.insert(*own).second) return;
    folders.push_back({folder, own && own == shipped ? "" : shown});
  };
  const std::string beside = fs::path(plan_file).parent_path().string();
  add(beside.empty() ? "." : beside, beside);
  std::istringstream path(lsos_path);
  for (std::string folder; std::getline(path, folder, ':');) {
    if (!folder.empty()) add(folder, folder);
  }
  add(shipped_folder, "");
  return folders;
}

std::string shipped_folder(const std::string& program_file, const std::string& built_from) {
  std::error_code error;
  for (fs::path at = fs::path(program_file).parent_path(); at.has_relative_path();
       at = at.parent_path()) {
    if (fs::is_directory(at / "share/lsos-host/events", error)) {
      return (at / "share/lsos-host").string();
    }
    if (fs::exists(at / "events/Route.lua", error)) return at.string();
  }
  return built_from;
}

std::string shipped_scripts() {
  std::error_code ignored;
  const std::string program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  return shipped_folder(program, source_folder);
}

std::string library_file() {
  std::error_code ignored;
  const std::string file = shipped_scripts() + "/lua/library.d.lua";
  return std::filesystem::exists(file, ignored) ? file : "";
}

}  // namespace lsos
