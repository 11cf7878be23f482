#include "product/run_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/error.h"
#include "base/files.h"
#include "base/output_error.h"
#include "base/whole_file.h"
#include "product/summary.h"
#include "record/log.h"

namespace lsos {

namespace fs = std::filesystem;

namespace {

// The summary is removed first: without it a run is unfinished, whatever other files remain. The
// log is moved last, see take_back().
constexpr std::array run_files{"summary.json",     "overlay.kml",   "overlay.kmz",  "report.html",
                               "report.png",       "plan.kml",      "mission.qgz",  "hillshade.tif",
                               "days.csv",         "estimate.json", "log.gpkg-wal", "log.gpkg-shm",
                               "log.gpkg-journal", "log.gpkg"};
// What a run that goes on needs.
constexpr std::array kept_files{"plan.kml", "log.gpkg", "log.gpkg-wal", "log.gpkg-shm",
                                "log.gpkg-journal"};

// Empty while a folder is being checked; contains `run_mark` from `prepare` on.
constexpr const char* lock_name = ".lsos-host.lock";
constexpr std::string_view run_mark = "a run of lsos-host that has not finished\n";

// Folder within, where the files of an earlier run lie while a new one begins.
constexpr const char* aside_name = ".lsos-host.earlier";
// The same folder once its run has been replaced.
constexpr const char* replaced_name = ".lsos-host.replaced";
constexpr std::array own_names{lock_name, aside_name, replaced_name};

enum class Content { nothing, finished_run, unfinished_run, foreign };

bool is_there(const fs::path& file) {
  std::error_code error;
  return fs::exists(fs::symlink_status(file, error));
}

// Rejects links, through which this program would read, or a later one write, somewhere else.
bool is_plain_file(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(fs::symlink_status(file, error));
}

// A lock file is written into, so it must be this program's and have no second name.
bool is_lock_file(const fs::path& file) {
  std::error_code error;
  if (!is_plain_file(file) || fs::hard_link_count(file, error) != 1) return false;
  const auto bytes = fs::file_size(file, error);
  return bytes == 0 || (bytes == run_mark.size() && read_file(file.string()) == run_mark);
}

// A folder within that holds nothing but files of a run.
bool is_folder_of_files(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(folder, error))) return false;
  return std::ranges::all_of(fs::directory_iterator(folder), [](const fs::directory_entry& entry) {
    const std::string name = entry.path().filename();
    return is_plain_file(entry.path()) && std::ranges::count(run_files, std::string_view(name)) > 0;
  });
}

bool is_log(const fs::path& file) {
  try {
    const LogReader log(file.string());
    return true;
  } catch (const InputError&) {
    return false;
  }
}

Content content_of(const fs::path& folder) {
  for (const char* name : run_files) {
    if (is_there(folder / name) && !is_plain_file(folder / name)) return Content::foreign;
  }
  const fs::path lock_file = folder / lock_name;
  if (is_there(lock_file) && !is_lock_file(lock_file)) return Content::foreign;
  for (const char* name : {aside_name, replaced_name}) {
    if (is_there(folder / name) && !is_folder_of_files(folder / name)) return Content::foreign;
  }

  if (is_summary(read_file((folder / "summary.json").string()).value_or(""))) {
    return Content::finished_run;
  }
  if (read_file(lock_file.string()).value_or("") == run_mark) return Content::unfinished_run;
  if (is_there(folder / "log.gpkg") && is_log(folder / "log.gpkg")) return Content::unfinished_run;
  const bool has_more =
      std::ranges::any_of(fs::directory_iterator(folder), [](const fs::directory_entry& entry) {
        return std::ranges::count(own_names, entry.path().filename()) == 0;
      });
  return has_more ? Content::foreign : Content::nothing;
}

void refuse_foreign(const std::string& path, const Content content) {
  if (content != Content::foreign) return;
  throw InputError({path},
                   "holds files that are no run of lsos-host, and these are never touched; name "
                   "another folder with -o");
}

[[noreturn]] void refuse_for_errno(const std::string& path, const char* what) {
  throw InputError({path},
                   fmt::format("{}: {}; name another folder with -o", what, std::strerror(errno)));
}

// Whether the open file is still the one of that name.
bool is_same_file(int descriptor, const std::string& file) {
  struct stat open_file {};
  struct stat named_file {};
  return ::fstat(descriptor, &open_file) == 0 && ::lstat(file.c_str(), &named_file) == 0 &&
         open_file.st_ino == named_file.st_ino && open_file.st_dev == named_file.st_dev;
}

}  // namespace

std::string default_run_folder(const std::string& plan_file) {
  return (fs::path("out") / fs::path(plan_file).stem()).string();
}

bool has_checkpoint(const std::string& folder) {
  try {
    return !LogReader(folder + "/log.gpkg").checkpoints().empty();
  } catch (const InputError&) {
    return false;
  }
}

RunFolder::RunFolder(const std::string& path, bool force) : path_(path) {
  while (path_.size() > 1 && path_.back() == '/') path_.pop_back();
  try {
    make_folders();
    // Check before locking as well: in a foreign folder not even a lock file may be created.
    refuse_foreign(path_, content_of(path_));
    lock();
    take_back();
    const Content content = content_of(path_);
    refuse_foreign(path_, content);
    if (content == Content::unfinished_run && !force) {
      throw InputError(
          {path_},
          fmt::format(
              "holds a run that has not finished; {}--force replaces it, -o "
              "names another folder",
              has_checkpoint(path_) ? "'lsos-host resume " + path_ + "' goes on with it, " : ""));
    }
    check_replaceable();
  } catch (const fs::filesystem_error& error) {
    release();
    throw InputError({path_},
                     fmt::format("cannot be the folder of a run: {}; name another folder with -o",
                                 error.code().message()));
  } catch (...) {
    release();
    throw;
  }
}

RunFolder::RunFolder(const std::string& path) : path_(path) {
  while (path_.size() > 1 && path_.back() == '/') path_.pop_back();
  const auto check = [this] {
    std::error_code unreadable;
    const bool is_folder = fs::is_directory(path_, unreadable);
    const Content content = is_folder ? content_of(path_) : Content::nothing;
    const bool has_run = content == Content::finished_run || content == Content::unfinished_run;
    if (has_run && is_there(fs::path(path_) / "log.gpkg")) return;
    throw InputError({path_}, is_folder ? "holds no run of lsos-host" : "no such folder");
  };
  try {
    check();  // before locking: in a foreign folder not even a lock file may be created
    lock();
    take_back();
    check();
    check_replaceable();
  } catch (const fs::filesystem_error& error) {
    release();
    throw InputError({path_}, error.code().message());
  } catch (...) {
    release();
    throw;
  }
}

RunFolder::~RunFolder() { release(); }

void RunFolder::make_folders() {
  if (std::error_code unreadable; fs::is_symlink(path_, unreadable)) {
    throw InputError({path_}, fmt::format("is a link, to {}: nothing is written through it; name "
                                          "that folder, or another, with -o",
                                          fs::read_symlink(path_, unreadable).string()));
  }
  if (is_there(path_) && !fs::is_directory(path_)) {
    throw InputError({path_}, "is a file, not a folder; name another folder with -o");
  }
  std::vector<std::string> missing;
  for (fs::path folder = path_; !folder.empty() && !is_there(folder);
       folder = folder.parent_path()) {
    missing.push_back(folder.string());
  }
  std::ranges::reverse(missing);
  for (const std::string& folder : missing) {
    if (fs::create_directory(folder)) made_folders_.push_back(folder);
  }
}

void RunFolder::lock() {
  const std::string lock_file = file(lock_name);
  // Retry only if the existing file was removed by its holder before it was opened or locked here.
  for (;;) {
    lock_ = ::open(lock_file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666);
    has_made_lock_file_ = lock_ >= 0;
    if (lock_ < 0 && errno == EEXIST) {
      lock_ = ::open(lock_file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
      if (lock_ < 0 && errno == ENOENT) continue;
    }
    if (lock_ < 0) refuse_for_errno(path_, "cannot be written");
    if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
      has_made_lock_file_ = false;
      if (errno != EWOULDBLOCK) refuse_for_errno(path_, "cannot be locked");
      throw InputError({path_},
                       "another lsos-host is writing there; wait for it, or name another folder "
                       "with -o");
    }
    if (is_same_file(lock_, lock_file)) return;
    ::close(lock_);
  }
}

void RunFolder::check_replaceable() {
  if (::access(path_.c_str(), W_OK | X_OK) != 0) refuse_for_errno(path_, "cannot be written");
  struct stat folder {};
  if (::stat(path_.c_str(), &folder) != 0) refuse_for_errno(path_, "cannot be read");
  const uid_t self = ::geteuid();
  // In a folder with the sticky bit, like /tmp, all may write but none may remove another's files.
  if ((folder.st_mode & S_ISVTX) == 0 || self == 0 || folder.st_uid == self) return;
  for (const char* name : run_files) {
    struct stat old {};
    if (::lstat(file(name).c_str(), &old) != 0 || old.st_uid == self) continue;
    errno = EPERM;
    refuse_for_errno(file(name), "of an earlier run cannot be removed");
  }
}

void RunFolder::prepare() {
  was_unfinished_ = content_of(path_) == Content::unfinished_run;
  mark_unfinished();
  const fs::path aside = file(aside_name);
  fs::create_directory(aside);
  for (const char* name : run_files) {
    if (is_there(file(name))) fs::rename(file(name), aside / name);
    remove(name);
  }
  has_run_aside_ = true;
}

void RunFolder::settle() {
  fs::rename(file(aside_name), file(replaced_name));
  has_run_aside_ = false;
  remove_replaced();
}

void RunFolder::remove_replaced() {
  const fs::path replaced = file(replaced_name);
  if (!is_folder_of_files(replaced)) return;
  for (const char* name : run_files) fs::remove(replaced / name);
  std::error_code ignored;
  fs::remove(replaced, ignored);  // fails where somebody else has put something there
}

// Without the log in it, moving there or back was interrupted, and what lies outside is of the
// earlier run, too.
void RunFolder::take_back() {
  remove_replaced();
  const fs::path aside = file(aside_name);
  if (!is_folder_of_files(aside)) return;
  if (is_plain_file(aside / "log.gpkg")) {
    for (const char* name : {"log.gpkg-wal", "log.gpkg-shm", "log.gpkg-journal"}) remove(name);
    fs::rename(aside / "log.gpkg", file("log.gpkg"));
  }
  for (const char* name : run_files) {
    if (is_plain_file(aside / name)) fs::rename(aside / name, file(name));
  }
  std::error_code ignored;
  fs::remove(aside, ignored);  // fails where somebody else has put something there
}

void RunFolder::reopen() {
  mark_unfinished();
  for (const char* name : run_files) {
    if (std::ranges::count(kept_files, std::string_view(name)) == 0) remove(name);
  }
}

void RunFolder::discard() {
  // What lies outside may be of the earlier run still, and the next RunFolder puts it together.
  if (!has_run_aside_) return;
  has_run_aside_ = false;
  std::ranges::for_each(run_files, [&](const char* name) { remove(name); });
  take_back();
  if (was_unfinished_) return;  // the mark stays
  if (::ftruncate(lock_, 0) != 0) {
    throw OutputError(fmt::format("{}: {}", file(lock_name), std::strerror(errno)));
  }
  is_prepared_ = false;
  has_made_lock_file_ = true;
  const bool has_run = content_of(path_) != Content::nothing;
  if (!has_run && made_folders_.empty()) made_folders_.push_back(path_);
}

void RunFolder::mark_unfinished() {
  // The lock file holds this mark or nothing, so one write suffices.
  if (::pwrite(lock_, run_mark.data(), run_mark.size(), 0) != std::ssize(run_mark)) {
    throw OutputError(fmt::format("{}: {}", file(lock_name), std::strerror(errno)));
  }
  is_prepared_ = true;
}

void RunFolder::clear() {
  std::ranges::for_each(run_files, [&](const char* name) { remove(name); });
  is_prepared_ = false;
  has_made_lock_file_ = true;
  made_folders_ = {path_};
  release();
}

void RunFolder::remove(const char* name) {
  // Left by a kill where the file system has no files without names.
  const std::string part = file(name) + std::string(part_suffix);
  if (is_plain_file(part)) ::unlink(part.c_str());
  if (::unlink(file(name).c_str()) != 0 && errno != ENOENT) {
    throw OutputError(fmt::format("{}: cannot be removed: {}", file(name), std::strerror(errno)));
  }
}

void RunFolder::release() {
  if (lock_ >= 0) {
    // The mark of an unfinished run stays.
    const bool is_done = is_prepared_ && is_summary(read_file(file("summary.json")).value_or(""));
    if (is_done || (!is_prepared_ && has_made_lock_file_)) ::unlink(file(lock_name).c_str());
    ::close(lock_);
    lock_ = -1;
  }
  if (is_prepared_) return;
  std::ranges::reverse(made_folders_);
  for (const std::string& folder : made_folders_) ::rmdir(folder.c_str());
  made_folders_.clear();
}

}  // namespace lsos
