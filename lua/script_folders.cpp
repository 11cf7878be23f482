#include "lua/script_folders.h"

#include <filesystem>
#include <sstream>

namespace lsos {

namespace fs = std::filesystem;

std::vector<ScriptFolder> script_folders(const std::string& plan_file, const std::string& lsos_path,
                                         const std::string& shipped_folder) {
  std::vector<ScriptFolder> folders;
  if (!plan_file.empty()) {
    const std::string beside = fs::path(plan_file).parent_path().string();
    folders.push_back({beside.empty() ? "." : beside, beside});
  }
  std::istringstream path(lsos_path);
  for (std::string folder; std::getline(path, folder, ':');) {
    if (!folder.empty()) folders.push_back({folder, folder});
  }
  folders.push_back({shipped_folder, ""});
  return folders;
}

std::string shipped_folder(const std::string& program_file, const std::string& source_folder) {
  std::error_code error;
  for (fs::path at = fs::path(program_file).parent_path(); at.has_relative_path();
       at = at.parent_path()) {
    if (fs::is_directory(at / "share/lsos-host/events", error)) {
      return (at / "share/lsos-host").string();
    }
    if (fs::exists(at / "events/Route.lua", error)) return at.string();
  }
  return source_folder;
}

}  // namespace lsos
