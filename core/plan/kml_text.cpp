#include "plan/kml_text.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/error.h"

namespace lsos {

std::string read_bytes(const std::string& file) {
  const Place place{file, 0};
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw InputError(place, "is a folder; a KML or KMZ file is wanted");
  }
  const auto refuse_above_limit = [&](std::uintmax_t size) {
    if (size <= max_kml_bytes) return;
    throw InputError(place, fmt::format("is larger than {} MiB", max_kml_bytes >> 20));
  };
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(place, fmt::format("cannot be opened: {}", std::strerror(errno)));
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error) refuse_above_limit(size);
  std::string bytes;
  std::string block(std::size_t{1} << 20, '\0');
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())),
         stream.gcount() > 0) {
    bytes.append(block, 0, static_cast<std::size_t>(stream.gcount()));
    refuse_above_limit(bytes.size());  // a pipe has no size
  }
  if (stream.bad())
    throw InputError(place, fmt::format("cannot be read: {}", std::strerror(errno)));
  return bytes;
}

KmlText kml_text(std::string bytes, const std::string& file) {
  refuse_foreign_bytes(bytes, file);
  return {file, to_utf8(std::move(bytes), file)};
}

}  // namespace lsos
