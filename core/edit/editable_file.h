// The file of a plan that is edited: KML, or a KMZ with one document.
#pragma once

#include <string>

namespace lsos {

class EditableFile {
 public:
  // `bytes`: of the plan `file`. Throws InputError where it is a GeoPackage, or a KMZ whose plan is
  // in several documents.
  EditableFile(std::string bytes, const std::string& file);

  // The document.
  const std::string& kml() const { return is_kmz() ? kml_ : bytes_; }
  bool is_kmz() const { return !name_.empty(); }
  // The file with another document; other files of a KMZ stay as they are.
  std::string with(const std::string& kml) const;

 private:
  std::string bytes_;
  std::string name_, kml_;  // of the document in a KMZ; "": it is none
};

}  // namespace lsos
