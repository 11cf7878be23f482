#include "access/bounded_projections.h"

#include <dlfcn.h>
#include <proj.h>

#include <cstdio>
#include <filesystem>
#include <mutex>
#include <sstream>
#include <string>
#include <string_view>

#include "access/file_access.h"
#include "access/refusal.h"

namespace lsos {

namespace {

std::FILE* file_of(PROJ_FILE_HANDLE* handle) { return reinterpret_cast<std::FILE*>(handle); }

// PROJ tries names without a folder in its own folders, then in the working one.
bool check(const char* path) {
  if (is_allowed(path)) return true;
  if (std::string_view(path).starts_with('/')) refuse(refused_file(path));
  return false;
}

PROJ_FILE_HANDLE* open(PJ_CONTEXT*, const char* path, PROJ_OPEN_ACCESS access, void*) {
  // It writes what it has fetched from the network, into the user's own folder.
  const char* mode = access == PROJ_OPEN_ACCESS_READ_ONLY     ? "rbe"
                     : access == PROJ_OPEN_ACCESS_READ_UPDATE ? "r+be"
                                                              : "w+be";
  return check(path) ? reinterpret_cast<PROJ_FILE_HANDLE*>(std::fopen(path, mode)) : nullptr;
}

std::size_t read(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, void* bytes, std::size_t size, void*) {
  return std::fread(bytes, 1, size, file_of(file));
}

std::size_t write(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, const void* bytes, std::size_t size, void*) {
  return std::fwrite(bytes, 1, size, file_of(file));
}

int seek(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, long long offset, int whence, void*) {
  return fseeko(file_of(file), offset, whence) == 0;
}

unsigned long long tell(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, void*) {
  return static_cast<unsigned long long>(ftello(file_of(file)));
}

void close(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, void*) { std::fclose(file_of(file)); }

int exists(PJ_CONTEXT*, const char* path, void*) {
  std::error_code unreadable;
  return is_allowed(path) && std::filesystem::exists(path, unreadable);
}

int make_folder(PJ_CONTEXT*, const char* path, void*) {
  std::error_code failed;
  return check(path) && std::filesystem::create_directory(path, failed);
}

int remove_file(PJ_CONTEXT*, const char* path, void*) {
  std::error_code failed;
  return check(path) && std::filesystem::remove(path, failed);
}

int rename_file(PJ_CONTEXT*, const char* from, const char* to, void*) {
  std::error_code failed;
  if (!check(from) || !check(to)) return false;
  std::filesystem::rename(from, to, failed);
  return !failed;
}

constexpr PROJ_FILE_API bounded_files{1,     open,   read,        write,       seek,       tell,
                                      close, exists, make_folder, remove_file, rename_file};

}  // namespace

void bound_projections() {
  static std::once_flag once;
  std::call_once(once, [] {
    std::istringstream folders(proj_info().searchpath);
    for (std::string folder; std::getline(folders, folder, ':');) allow_folder(folder);
  });
}

}  // namespace lsos

// GDAL makes a context a thread and gives nobody a hand on it, and PROJ's default context passes
// its files on to none. This function of the program stands before that of the library, also for
// GDAL's calls.
extern "C" PJ_CONTEXT* proj_context_create() {
  using Create = PJ_CONTEXT* (*)();
  static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "proj_context_create"));
  PJ_CONTEXT* context = create == nullptr ? nullptr : create();
  if (context != nullptr && lsos::is_access_restricted()) {
    lsos::bound_projections();
    proj_context_set_fileapi(context, &lsos::bounded_files, nullptr);
  }
  return context;
}
