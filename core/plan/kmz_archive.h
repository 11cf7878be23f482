// The KML documents inside a KMZ archive.
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
  // `bytes` must outlive it. Throws InputError where they are no archive.
  KmzArchive(const std::string& bytes, std::string file, std::size_t max_bytes = max_kml_bytes);

  // doc.kml, as the KMZ convention has it, else the first file in the archive that ends in .kml.
  // Throws InputError when there is none.
  std::string document_name() const;
  // The KML file of the archive that a link in one of its documents leads to; "" when it leads to
  // none of them.
  std::string resolved(const std::string& href, const std::string& document) const;
  // For messages: "plan.kmz/doc.kml".
  std::string path(const std::string& name) const { return file_ + "/" + name; }
  // Throws InputError when it is damaged, or when all that was unpacked is above the limit.
  std::string unpacked(const std::string& name);

 private:
  std::string file_;
  ZipHandle archive_;
  std::size_t max_bytes_, left_bytes_;
};

}  // namespace lsos
