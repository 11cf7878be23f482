#include "edit/editable_file.h"

#include <fstream>

#include "base/bounded_file.h"
#include "base/error.h"
#include "plan/kml_reader.h"
#include "plan/kmz_archive.h"
#include "plan/layer_reader.h"

namespace lsos {

namespace {

// A plan in a GeoPackage is kept with its run as KML, so its bytes do not tell.
bool is_geopackage_file(const std::string& file) {
  if (!other_than_file(file).empty()) return false;  // a pipe was read before
  std::string begin(64, '\0');
  std::ifstream(file, std::ios::binary)
      .read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return is_geopackage(begin);
}

}  // namespace

EditableFile::EditableFile(std::string bytes, const std::string& file) : bytes_(std::move(bytes)) {
  if (is_geopackage_file(file)) {
    throw InputError({file, 0},
                     "is a GeoPackage, and KML or KMZ is edited: save it as KML from your GIS, or "
                     "edit its tables there");
  }
  if (!is_zip(bytes_)) return;
  KmzArchive archive(bytes_, file);
  name_ = archive.document_name();
  kml_ = archive.unpacked(name_);
  const std::size_t in_all = parse_kml(bytes_, file).placemarks.size();
  if (parse_kml(kml_, archive.path(name_)).placemarks.size() != in_all) {
    throw InputError({file, 0},
                     "has its plan in several documents, and one is edited: save it as one KML");
  }
}

std::string EditableFile::with(const std::string& kml) const {
  return is_kmz() ? repacked_zip(bytes_, name_, kml) : kml;
}

}  // namespace lsos
