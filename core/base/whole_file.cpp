#include "base/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/child_process.h"
#include "base/error.h"
#include "base/output_error.h"

namespace lsos {

namespace {

constexpr mode_t file_mode = 0666;  // less the user's umask

// Reasons that lie in the name that was given, and not in the machine.
constexpr std::array wrong_places{EACCES, EPERM,  EROFS,        ENOENT, ENOTDIR,
                                  EISDIR, EEXIST, ENAMETOOLONG, ELOOP};

const char* mode_name(mode_t mode) {
  if (S_ISDIR(mode)) return "is a folder";
  if (S_ISFIFO(mode)) return "is a named pipe";
  if (S_ISSOCK(mode)) return "is a socket";
  return "is a device";
}

// Also what a link leads to counts: /dev/stdout is one to a terminal or pipe.
void refuse_other_than_file(int folder, const std::string& name, const std::string& file) {
  struct stat there {};
  if (::fstatat(folder, name.c_str(), &there, 0) != 0 || S_ISREG(there.st_mode)) return;
  throw InputError({}, fmt::format("{}: {}, and no file that could be replaced; another name is "
                                   "wanted",
                                   file, mode_name(there.st_mode)));
}

// Whether an open folder is one of the machine's own, whose links to files are no files:
// /dev/stdout leads to where the output goes, and would be replaced itself.
bool is_of_machine(int folder) {
  std::error_code unreadable;
  const std::string path =
      std::filesystem::read_symlink(fmt::format("/proc/self/fd/{}", folder), unreadable).string() +
      "/";
  return path.starts_with("/proc/") ||
         (path.starts_with("/dev/") && !path.starts_with("/dev/shm/"));
}

}  // namespace

WholeFile::WholeFile(const std::string& file, Kind kind) : file_(file) {
  const std::filesystem::path path = file;
  name_ = path.filename();
  if (name_.empty() || name_ == "." || name_ == "..") refuse(EISDIR);
  const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
  folder_ = ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  if (folder_ < 0) refuse(errno);
  try {
    check_target();
    if (kind == Kind::named || !make_unnamed()) make_named();
  } catch (...) {
    ::close(folder_);
    throw;
  }
}

WholeFile::~WholeFile() {
  if (!part_.empty()) ::unlinkat(folder_, part_.c_str(), 0);
  if (descriptor_ >= 0) ::close(descriptor_);
  ::close(folder_);
}

void WholeFile::check_target() const {
  refuse_other_than_file(folder_, name_, file_);
  if (!is_of_machine(folder_)) return;
  throw InputError(
      {}, fmt::format("{}: lies in a folder of the machine, where no file is kept; another name is "
                      "wanted",
                      file_));
}

// Such a file gets its name through /proc, which may be absent. Not every file system has them.
bool WholeFile::make_unnamed() {
  descriptor_ = ::openat(folder_, ".", O_TMPFILE | O_RDWR | O_CLOEXEC, file_mode);
  if (descriptor_ >= 0 && ::access(open_name().c_str(), F_OK) == 0) return true;
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  return false;
}

template <class Take>
void WholeFile::take_free_name(Take take) {
  constexpr std::size_t longest = 200;  // leaves room in the 255 bytes of a name
  const std::string begin = name_.substr(0, longest);
  for (int number = 1;; ++number) {
    std::string name = number == 1 ? fmt::format("{}{}", begin, part_suffix)
                                   : fmt::format("{}.{}{}", begin, number, part_suffix);
    if (take(name)) {
      part_ = std::move(name);
      return;
    }
    if (errno != EEXIST) refuse(errno);
  }
}

void WholeFile::make_named() {
  take_free_name([&](const std::string& name) {
    descriptor_ = ::openat(folder_, name.c_str(),
                           O_CREAT | O_EXCL | O_NOFOLLOW | O_RDWR | O_CLOEXEC, file_mode);
    return descriptor_ >= 0;
  });
}

std::string WholeFile::open_name() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

void WholeFile::write(std::string_view bytes) {
  if (!write_all(descriptor_, bytes)) refuse(errno);
}

bool WholeFile::link(const std::string& name) {
  return ::linkat(AT_FDCWD, open_name().c_str(), folder_, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

// Some file systems report only now that there was no space.
void WholeFile::close() {
  const int closed = std::exchange(descriptor_, -1);
  if (::close(closed) != 0) refuse(errno);
}

void WholeFile::replace() {
  check_target();
  if (part_.empty()) take_free_name([&](const std::string& name) { return link(name); });
  close();
  if (::renameat(folder_, part_.c_str(), folder_, name_.c_str()) != 0) refuse(errno);
  part_.clear();
}

void WholeFile::place() {
  if (part_.empty()) take_free_name([&](const std::string& name) { return link(name); });
  close();
  if (::renameat2(folder_, part_.c_str(), folder_, name_.c_str(), RENAME_NOREPLACE) == 0) {
    part_.clear();
    return;
  }
  // NFS has hard links instead; the destructor removes the part.
  if (errno != EINVAL || ::linkat(folder_, part_.c_str(), folder_, name_.c_str(), 0) != 0) {
    refuse(errno);
  }
}

void WholeFile::refuse(int error) const {
  const std::string text =
      fmt::format("{}: {}", file_,
                  error == EEXIST ? "is there already; it is not replaced" : std::strerror(error));
  if (std::ranges::count(wrong_places, error) > 0) throw InputError({}, text);
  throw OutputError(text);
}

}  // namespace lsos
