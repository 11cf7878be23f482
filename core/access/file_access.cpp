#include "access/file_access.h"

#include <fmt/format.h>

#include <atomic>
#include <filesystem>
#include <mutex>
#include <set>
#include <shared_mutex>

namespace lsos {

namespace {

namespace fs = std::filesystem;

struct Allowed {
  std::shared_mutex mutex;
  std::set<std::string> folders;
  std::set<std::string> files;  // without their extensions
};

Allowed& allowed() {
  static Allowed all;
  return all;
}

std::atomic<bool> is_restricted = false;
std::atomic<bool> may_use_network = true;

// `path` without links and dots; of what does not exist, the part that does without links.
fs::path resolved(const std::string& path) {
  std::error_code unreadable;
  const fs::path absolute = fs::absolute(path.empty() ? "." : path, unreadable);
  fs::path canonical = fs::weakly_canonical(absolute, unreadable);
  if (unreadable) canonical = absolute.lexically_normal();
  return canonical.has_filename() ? canonical : canonical.parent_path();
}

// Whether `path` is one of the folders or lies below one, of which there may be thousands.
bool lies_in_any(const std::set<std::string>& folders, fs::path path) {
  while (!folders.contains(path.native())) {
    if (!path.has_relative_path()) return false;
    path = path.parent_path();
  }
  return true;
}

// "/maps/dem" of "/maps/dem.tif" and "/maps/dem.tif.aux.xml".
fs::path stem_of(const fs::path& file) {
  const std::string name = file.filename();
  return file.parent_path() / name.substr(0, name.find('.', 1));
}

void add(std::set<std::string>& paths, const fs::path& path) {
  const std::unique_lock lock(allowed().mutex);
  paths.insert(path.native());
}

}  // namespace

void restrict_access(bool has_network) {
  may_use_network = has_network;
  is_restricted = true;
}

bool is_access_restricted() { return is_restricted; }

bool has_network_access() { return may_use_network; }

void allow_folder(const std::string& folder) { add(allowed().folders, resolved(folder)); }

void allow_file(const std::string& file) { add(allowed().files, stem_of(resolved(file))); }

std::string file_on_disk(const std::string& name) {
  std::string rest = name;
  while (rest.starts_with("/vsi") || rest.starts_with("vsi")) {
    const std::size_t slash = rest.find('/', 1);
    if (slash == std::string::npos) break;
    rest.erase(0, slash + 1);
  }
  if (rest == name) return name;
  if (rest.starts_with('{')) return rest.substr(1, rest.find('}') - 1);
  fs::path path = rest;
  std::error_code absent;
  while (path.has_relative_path() && !fs::exists(path, absent)) path = path.parent_path();
  return path.string();
}

void allow_raster(const std::string& name) {
  allow_folder(fs::path(file_on_disk(name)).parent_path().string());
}

bool is_allowed(const std::string& path) {
  if (!is_restricted) return true;
  const fs::path file = resolved(path);
  const std::shared_lock lock(allowed().mutex);
  return allowed().files.contains(stem_of(file).native()) || lies_in_any(allowed().folders, file);
}

std::string refused_file(const std::string& path) {
  return fmt::format(
      "'{}' lies outside the plan's folder and those of LSOS_PATH; --allow-files '{}' or "
      "LSOS_ALLOW_FILES allows what lies there",
      path, resolved(path).parent_path().string());
}

std::string refused_network(const std::string& name) {
  return fmt::format("'{}' needs the network; --allow-network allows it", name);
}

}  // namespace lsos
