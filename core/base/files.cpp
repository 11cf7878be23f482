#include "base/files.h"

#include <sys/stat.h>

#include "base/bounded_file.h"
#include "base/whole_file.h"

namespace lsos {

void write_file(const std::string& file, std::string_view bytes) {
  WholeFile whole(file);
  whole.write(bytes);
  whole.replace();
}

void write_new_file(const std::string& file, std::string_view bytes) {
  WholeFile whole(file);
  whole.write(bytes);
  whole.place();
}

std::optional<FileIdentity> identity_of(const std::string& file) {
  struct stat there {};
  if (::stat(file.c_str(), &there) != 0) return std::nullopt;
  return FileIdentity{there.st_dev, there.st_ino};
}

std::optional<std::string> read_file(const std::string& file) { return read_bounded(file).value; }

}  // namespace lsos
