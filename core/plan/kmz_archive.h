// Reads and replaces the KML documents inside a KMZ archive.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "plan/kml_text.h"
#include "plan/zip_handle.h"

namespace lsos {

bool is_zip(std::string_view bytes);

class KmzArchive {
 public:
  // `bytes` must outlive the archive. Throws InputError when they are not an archive.
  KmzArchive(const std::string& bytes, std::string file, std::size_t max_bytes = max_kml_bytes);

  // Name of the main document: doc.kml by KMZ convention, else the first file in the archive that
  // ends in .kml. Throws InputError when there is none.
  std::string document_name() const;
  // Name of the KML file in the archive to which `href` in `document` leads; "" when it leads to
  // none.
  std::string resolved(const std::string& href, const std::string& document) const;
  // Path for messages: "plan.kmz/doc.kml".
  std::string path(const std::string& name) const { return file_ + "/" + name; }
  bool has(const std::string& name) const;
  // Bytes of a file in the archive. Throws InputError when it is damaged, or when the bytes
  // unpacked so far exceed the limit in total.
  std::string unpacked(const std::string& name);

 private:
  std::string file_;
  ZipHandle archive_;
  std::size_t max_bytes_, left_bytes_;
};

// The archive with other bytes in one of its files, whose name it has; the others stay as they are.
// Equal archives and bytes give equal bytes at any time, as that file is dated 1 January 1980.
// Throws std::runtime_error when memory runs out.
std::string repacked_zip(const std::string& zip, const std::string& name, const std::string& bytes);

}  // namespace lsos
