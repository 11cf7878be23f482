#include "lua/host/catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/bounded_file.h"
#include "base/sha256.h"
#include "base/utf8.h"
#include "lua/host/script_folders.h"
#include "lua/runtime/source_budget.h"

namespace lsos {

namespace fs = std::filesystem;

namespace {

constexpr std::pair<ScriptKind, const char*> kind_folders[] = {{ScriptKind::event, "events"},
                                                               {ScriptKind::rover, "rovers"},
                                                               {ScriptKind::soil, "terrain/soils"},
                                                               {ScriptKind::terrain, "terrain"},
                                                               {ScriptKind::shared, "lib"}};

// Bounds of scripts that are not shipped: of a kind, and together in one folder of scripts, so that
// what came with a plan takes nothing from the user's own.
constexpr std::size_t scripts_max = 1000;
constexpr std::size_t source_bytes_together = std::size_t{16} << 20;

// Reads the text of a script, or says why it cannot be used.
void read_source(Script& script, const fs::path& path, std::size_t& bytes_left) {
  FileBounds bounds;
  bounds.bytes_max = source_bytes_max;
  Parsed<std::string> source = read_bounded(path.string(), bounds);
  if (!source) {
    script.unread = std::move(source.why);
  } else if (!script.is_shipped && source.value->size() > bytes_left) {
    script.unread = fmt::format("is not read: the scripts of a folder may have {} MiB together",
                                source_bytes_together >> 20);
  } else {
    if (!script.is_shipped) bytes_left -= source.value->size();
    script.source = *std::move(source.value);
  }
  script.sha256 = sha256_hex(script.source);
}

// The scripts of one folder in byte order of their names.
std::vector<Script> scripts_in(const ScriptFolder& folder, ScriptKind kind, const char* sub,
                               std::size_t& bytes_left, Faults& faults) {
  std::vector<Script> scripts;
  const fs::path path = fs::path(folder.path) / sub;
  std::error_code absent;
  const bool is_shipped = fs::equivalent(folder.path, shipped_scripts(), absent);
  const std::string shown = (fs::path(folder.shown) / sub).string();
  std::error_code error;
  for (fs::directory_iterator entry(path, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path file = entry->path().filename();
    if (file.extension() != ".lua") continue;
    if (!is_name(file.string())) {
      faults.warning({shown, 0}, "has a script whose name is no text (UTF-8); it is left out");
      continue;
    }
    Script script;
    script.kind = kind;
    script.name = file.stem().string();
    script.file = (fs::path(shown) / file).string();
    script.folder = path.string();
    script.is_shipped = is_shipped;
    scripts.push_back(std::move(script));
    if (scripts.size() > scripts_max && !is_shipped) {
      faults.warning({shown, 0}, fmt::format("has more than {} scripts; so many are allowed in one "
                                             "folder, and none is used",
                                             scripts_max));
      return {};
    }
  }
  const bool is_absent =
      error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory;
  if (error && !is_absent) {
    faults.warning({shown, 0}, fmt::format("cannot be read: {}", error.message()));
  }
  std::ranges::sort(scripts, {}, &Script::name);
  for (Script& script : scripts) read_source(script, path / (script.name + ".lua"), bytes_left);
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
  std::map<std::string, std::size_t> bytes_left;  // by folder
  for (const auto& [kind, sub] : kind_folders) {
    std::map<std::string, Script> chosen;
    for (const ScriptFolder& folder : folders) {
      std::size_t& left = bytes_left.try_emplace(folder.path, source_bytes_together).first->second;
      for (Script& script : scripts_in(folder, kind, sub, left, faults_)) {
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
