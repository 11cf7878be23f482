// A file in memory, as which GDAL makes what the program then writes.
#pragma once

#include <string>
#include <string_view>

namespace lsos {

// GDAL's drivers make further files beside the one that they are asked for (.ovr.tmp, .aux.xml,
// -journal), append to what lies there and write through links. In memory nothing lies there.
// Objects have folders of their own.
class MemoryFile {
 public:
  // `name`: as the driver needs it, "plan.xlsx".
  explicit MemoryFile(const std::string& name);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  // What GDAL knows it by.
  const std::string& name() const { return name_; }
  // Its bytes, once the dataset is closed; valid until the file is opened again. Empty where GDAL
  // has made none.
  std::string_view bytes() const;

 private:
  std::string folder_, name_;
};

}  // namespace lsos
