#include "base/output_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace lsos {

namespace fs = std::filesystem;

void check_output(const std::string& option, const std::string& file,
                  const std::vector<std::string>& endings, const std::vector<std::string>& inputs,
                  Faults& faults) {
  if (file.empty()) return;
  const std::string shown = fmt::format("{} {}", option, file);
  if (std::ranges::none_of(endings, [&](const auto& end) { return file.ends_with(end); })) {
    faults.error({}, fmt::format("{}: the name must end in {}", shown, fmt::join(endings, " or ")));
  }
  const fs::path folder = fs::path(file).parent_path();
  if (!folder.empty() && !fs::is_directory(folder)) {
    faults.error({}, fmt::format("{}: there is no folder {}", shown, folder.string()));
  } else if (::access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0) {
    faults.error({},
                 fmt::format("{}: the folder cannot be written: {}", shown, std::strerror(errno)));
  }
  for (const std::string& input : inputs) {
    std::error_code is_absent;
    if (!fs::equivalent(file, input, is_absent)) continue;
    faults.error({}, fmt::format("{}: the command reads this file; another name is wanted", shown));
  }
}

void check_free(const std::string& option, const std::string& file, const std::string& advice,
                Faults& faults) {
  std::error_code absent;
  if (file.empty() || !fs::exists(fs::symlink_status(file, absent))) return;
  faults.error({}, fmt::format("{} {}: is there already; {}", option, file, advice));
}

void refuse_links(const std::string& folder, const std::string& name) {
  fs::path path = folder;
  for (const fs::path& part : fs::path(name)) {
    path /= part;
    std::error_code unreadable;
    if (!fs::is_symlink(path, unreadable)) continue;
    const std::string target = fs::read_symlink(path, unreadable);
    throw InputError({path.string()},
                     fmt::format("is a link, to {}: nothing is written through it; remove it, or "
                                 "name a folder",
                                 target));
  }
}

void check_replaceable(const std::string& file, std::string_view mark) {
  std::error_code absent;
  if (!fs::exists(file, absent)) return;
  if (fs::is_regular_file(file)) {
    std::string begin(mark.size(), '\0');
    std::ifstream(file, std::ios::binary)
        .read(begin.data(), static_cast<std::streamsize>(begin.size()));
    if (fs::file_size(file) == 0 || begin == mark) return;
  }
  throw std::runtime_error(
      fmt::format("{} is there and is something else; another name is wanted", file));
}

}  // namespace lsos
