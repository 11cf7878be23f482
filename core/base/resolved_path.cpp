#include "base/resolved_path.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace lsos {

namespace {

constexpr std::array<std::string_view, 5> archives{"/vsizip/", "/vsigzip/", "/vsitar/", "/vsi7z/",
                                                   "/vsirar/"};

// Length in bytes of the leading names of archive systems; an archive may lie within another.
std::size_t prefix_bytes(std::string_view path) {
  std::size_t bytes = 0;
  for (;;) {
    const auto found = std::ranges::find_if(
        archives, [&](std::string_view each) { return path.substr(bytes).starts_with(each); });
    if (found == archives.end()) break;
    bytes += found->size();
    if (path.substr(bytes).starts_with("vsi")) --bytes;  // "/vsizip/vsitar/": one slash for both
  }
  if (path.substr(bytes).starts_with('{')) ++bytes;  // "/vsizip/{ARCHIVE}/FILE"
  return bytes;
}

}  // namespace

std::string resolved_path(const std::string& folder, const std::string& path) {
  const std::size_t prefix = prefix_bytes(path);
  const std::string rest = path.substr(prefix);
  if (rest.starts_with('/')) return path;
  return path.substr(0, prefix) +
         (std::filesystem::path(folder) / rest).lexically_normal().string();
}

}  // namespace lsos
