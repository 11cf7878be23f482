#include "plan/kml_text.h"

#include "base/bounded_file.h"
#include "base/error.h"

namespace lsos {

std::string read_bytes(const std::string& file) {
  FileBounds bounds;
  bounds.bytes_max = max_kml_bytes;
  bounds.may_be_pipe = true;
  Parsed<std::string> bytes = read_bounded(file, bounds);
  if (bytes) return *std::move(bytes.value);
  const bool is_other = bytes.why == other_than_file(file);
  throw InputError({file, 0}, bytes.why + (is_other ? "; a KML or KMZ file is wanted" : ""));
}

KmlText kml_text(std::string bytes, const std::string& file) {
  refuse_foreign_bytes(bytes, file);
  return {file, to_utf8(std::move(bytes), file)};
}

}  // namespace lsos
