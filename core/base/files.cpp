#include "base/files.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "base/bounded_file.h"
#include "base/error.h"
#include "base/output_error.h"

namespace lsos {

void write_file(const std::string& file, std::string_view bytes) {
  const std::string part = file + std::string(part_suffix);
  errno = 0;
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (out && std::rename(part.c_str(), file.c_str()) == 0) return;
  const std::string why = errno == 0 ? "cannot be written" : std::strerror(errno);
  const bool is_place_wrong = errno == EACCES || errno == EPERM || errno == EROFS ||
                              errno == ENOENT || errno == ENOTDIR || errno == EISDIR;
  std::remove(part.c_str());
  if (is_place_wrong) throw InputError({}, fmt::format("{}: {}", file, why));
  throw OutputError(fmt::format("{}: {}", file, why));
}

std::optional<std::string> read_file(const std::string& file) { return read_bounded(file).value; }

}  // namespace lsos
