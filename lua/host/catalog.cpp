#include "lua/host/catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/sha256.h"

namespace lsos {

namespace fs = std::filesystem;

namespace {

constexpr std::pair<ScriptKind, const char*> kind_folders[] = {{ScriptKind::event, "events"},
                                                               {ScriptKind::rover, "rovers"},
                                                               {ScriptKind::soil, "terrain/soils"},
                                                               {ScriptKind::terrain, "terrain"},
                                                               {ScriptKind::shared, "lib"}};

std::string read_bytes(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError({path.string(), 0}, "cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

// The scripts of one folder in byte order of their names.
std::vector<Script> scripts_in(const ScriptFolder& folder, ScriptKind kind, const char* sub) {
  std::vector<Script> scripts;
  const fs::path path = fs::path(folder.path) / sub;
  std::error_code no_folder;
  for (const auto& entry : fs::directory_iterator(path, no_folder)) {
    if (entry.path().extension() != ".lua" || !entry.is_regular_file()) continue;
    Script script;
    script.kind = kind;
    script.name = entry.path().stem().string();
    script.file = (fs::path(folder.shown) / sub / entry.path().filename()).string();
    script.folder = path.string();
    script.source = read_bytes(entry.path());
    script.sha256 = sha256_hex(script.source);
    scripts.push_back(std::move(script));
  }
  std::ranges::sort(scripts, {}, &Script::name);
  return scripts;
}

std::vector<ScriptFolder> plain_folders(const std::vector<std::string>& paths) {
  std::vector<ScriptFolder> folders;
  for (const std::string& path : paths) folders.push_back({path, path});
  return folders;
}

}  // namespace

Catalog::Catalog(const std::vector<std::string>& folders) : Catalog(plain_folders(folders)) {}

Catalog::Catalog(const std::vector<ScriptFolder>& folders) {
  for (const auto& [kind, sub] : kind_folders) {
    std::map<std::string, Script> chosen;
    for (const ScriptFolder& folder : folders) {
      for (Script& script : scripts_in(folder, kind, sub)) {
        const auto [first, is_new] = chosen.try_emplace(script.name, script);
        if (is_new || first->second.sha256 == script.sha256) continue;
        faults_.warning({first->second.file, 0},
                        fmt::format("is used in place of {}/{}.lua", script.folder, script.name));
      }
    }
    for (auto& [name, script] : chosen) scripts_.push_back(std::move(script));
  }
  load_all();
}

}  // namespace lsos
