#include "access/bounded_files.h"

#include <cpl_conv.h>
#include <cpl_string.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <memory>
#include <set>
#include <string_view>
#include <vector>

#include "access/file_access.h"
#include "access/forwarded_files.h"
#include "access/open_budget.h"
#include "access/refusal.h"
#include "base/bounded_file.h"

namespace lsos {

namespace {

constexpr std::size_t companion_bytes_max = std::size_t{64} << 20;

// Whether GDAL reads such a file into memory: what lies beside a raster. VRTs are told by what
// stands in them, where they are opened.
bool is_companion(const char* path) {
  static constexpr std::array endings{"prj", "xml", "hdr", "tfw", "wld"};
  const std::string ending = CPLGetExtension(path);
  return std::ranges::any_of(endings, [&](const char* end) { return EQUAL(ending.c_str(), end); });
}

constexpr const char* make_geotiff =
    "; gdal_translate makes a GeoTIFF, which needs no file beside it";

// The file system of the machine.
class BoundedFiles : public ForwardedFiles {
 public:
  // Takes over `files`, which GDAL owned.
  explicit BoundedFiles(VSIFilesystemHandler* files) : ForwardedFiles(files), owned_(files) {}

  VSIVirtualHandle* Open(const char* path, const char* access, bool sets_error,
                         CSLConstList options) override {
    const bool is_read = access[0] == 'r';
    if (!check(path) || (is_read && !is_file(path))) return nullptr;
    if (!spend_file()) {
      refuse(too_many_files());
      return nullptr;
    }
    return files().Open(path, access, sets_error, options);
  }
  int Stat(const char* path, VSIStatBufL* stat, int flags) override {
    if (is_allowed(path)) return files().Stat(path, stat, flags);
    errno = ENOENT;
    return -1;
  }
  char** ReadDirEx(const char* folder, int files_max) override {
    return is_allowed(folder) ? files().ReadDirEx(folder, files_max) : nullptr;
  }
  char** SiblingFiles(const char* path) override {
    return is_allowed(path) ? files().SiblingFiles(path) : nullptr;
  }
  VSIDIR* OpenDir(const char* folder, int depth, const char* const* options) override {
    return is_allowed(folder) ? files().OpenDir(folder, depth, options) : nullptr;
  }
  int Unlink(const char* path) override { return check(path) ? files().Unlink(path) : -1; }
  int Rename(const char* from, const char* to) override {
    return check(from) && check(to) ? files().Rename(from, to) : -1;
  }
  int Mkdir(const char* folder, long mode) override {
    return check(folder) ? files().Mkdir(folder, mode) : -1;
  }
  int Rmdir(const char* folder) override { return check(folder) ? files().Rmdir(folder) : -1; }

 private:
  static bool check(const char* path) {
    if (is_allowed(path)) return true;
    // GDAL asks there what machine it runs on before it calls a server.
    if (!std::string_view(path).starts_with("/sys/")) refuse(refused_file(path));
    errno = EACCES;
    return false;
  }

  // Whether it can be opened without waiting for ever, which a pipe cannot, and read whole where
  // GDAL does so. GDAL itself says of a folder that it is none.
  static bool is_file(const char* path) {
    std::string why = other_than_file(path);
    if (why.empty() && is_companion(path)) {
      why = larger_than(path, companion_bytes_max);
      if (!why.empty()) why += make_geotiff;
    }
    if (why.empty()) return true;
    if (why != is_folder) refuse(fmt::format("'{}' {}", path, why));
    errno = EACCES;
    return false;
  }

  std::unique_ptr<VSIFilesystemHandler> owned_;
};

// Files in archives: a few kilobytes of an archive can stand for gigabytes of such a file.
class PackedFiles : public ForwardedFiles {
 public:
  // Takes over `files`, which GDAL owned.
  explicit PackedFiles(VSIFilesystemHandler* files) : ForwardedFiles(files), owned_(files) {}

  VSIVirtualHandle* Open(const char* path, const char* access, bool sets_error,
                         CSLConstList options) override {
    VSIVirtualHandle* file = files().Open(path, access, sets_error, options);
    if (file == nullptr || access[0] != 'r' || !is_companion(path)) return file;
    // Read rather than asked, as a directory's sizes need not be true and a stream has none.
    std::vector<char> some(1 << 20);
    for (std::size_t read = 0; read <= companion_bytes_max; read += some.size()) {
      if (file->Read(some.data(), 1, some.size()) == some.size()) continue;
      file->Seek(0, SEEK_SET);
      return file;
    }
    file->Close();
    delete file;
    refuse(fmt::format("'{}' {}{}", path, too_large(companion_bytes_max), make_geotiff));
    errno = EACCES;
    return nullptr;
  }

 private:
  std::unique_ptr<VSIFilesystemHandler> owned_;
};

bool is_stream(std::string_view prefix) { return prefix.starts_with("/vsistd"); }

// A file system of the network, or a standard stream of the program.
class RefusedFiles : public VSIFilesystemHandler {
 public:
  VSIVirtualHandle* Open(const char* path, const char*, bool, CSLConstList) override {
    tell(path);
    return nullptr;
  }
  int Stat(const char* path, VSIStatBufL*, int) override {
    tell(path);
    return -1;
  }
  bool IsLocal(const char*) override { return false; }

 private:
  static void tell(const char* path) {
    refuse(is_stream(path) ? fmt::format("'{}' is a stream of the program, and no raster", path)
                           : refused_network(path));
    errno = EACCES;
  }
};

// A file system of the network where that is allowed, which is no way to local files.
class WebFiles : public VSIFilesystemHandler {
 public:
  explicit WebFiles(VSIFilesystemHandler* files) : files_(files) {}

  VSIVirtualHandle* Open(const char* path, const char* access, bool sets_error,
                         CSLConstList options) override {
    return check(path) ? files_->Open(path, access, sets_error, options) : nullptr;
  }
  int Stat(const char* path, VSIStatBufL* stat, int flags) override {
    return check(path) ? files_->Stat(path, stat, flags) : -1;
  }
  char** ReadDirEx(const char* folder, int files_max) override {
    return check(folder) ? files_->ReadDirEx(folder, files_max) : nullptr;
  }
  bool IsLocal(const char*) override { return false; }

 private:
  static bool check(const char* path) {
    std::string lower(path);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
    if (lower.find("file:") == std::string::npos && lower.find("%3a") == std::string::npos) {
      return true;
    }
    refuse(fmt::format("'{}' is no address of the network", path));
    errno = EACCES;
    return false;
  }

  VSIFilesystemHandler* files_;  // that of GDAL, which serves several prefixes and stays
};

// File systems that read memory, or local files through this one.
const std::set<std::string_view> local_prefixes = {"/vsimem/",   "/vsizip/",    "/vsigzip/",
                                                   "/vsitar/",   "/vsisparse/", "/vsisubfile/",
                                                   "/vsicrypt/", "/vsicached?"};

// All others lead to the network, or to the program's own standard streams.
void bound_other_file_systems() {
  std::set<VSIFilesystemHandler*> replaced;  // some serve several prefixes
  const CPLStringList prefixes(VSIFileManager::GetPrefixes());
  for (int i = 0; i < prefixes.size(); ++i) {
    const char* prefix = prefixes[i];
    if (local_prefixes.contains(prefix)) continue;
    VSIFilesystemHandler* handler = VSIFileManager::GetHandler(prefix);
    if (has_network_access() && !is_stream(prefix)) {
      VSIFileManager::InstallHandler(prefix, new WebFiles(handler));
      continue;
    }
    replaced.insert(handler);
    VSIFileManager::InstallHandler(prefix, new RefusedFiles);
  }
  for (VSIFilesystemHandler* handler : replaced) delete handler;
}

}  // namespace

void bound_file_systems() {
  // GDAL owns the handlers that it is given.
  VSIFileManager::InstallHandler("", new BoundedFiles(VSIFileManager::GetHandler("")));
  for (const char* prefix : {"/vsizip/", "/vsitar/", "/vsigzip/"}) {
    VSIFileManager::InstallHandler(prefix, new PackedFiles(VSIFileManager::GetHandler(prefix)));
  }
  bound_other_file_systems();
}

}  // namespace lsos
