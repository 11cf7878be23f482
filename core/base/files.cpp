#include "base/files.h"

#include <sys/stat.h>

#include <fstream>
#include <sstream>
#include <utility>

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

std::optional<std::string> read_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  std::ostringstream bytes;
  // Inserting an empty buffer would set the failbit; a folder can be opened but fails on reading.
  if (in.peek() != std::ifstream::traits_type::eof()) bytes << in.rdbuf();
  if (in.bad() || bytes.bad()) return std::nullopt;
  return std::move(bytes).str();
}

}  // namespace lsos
