#include "access/memory_file.h"

#include <cpl_vsi.h>
#include <fmt/format.h>

#include <atomic>

namespace lsos {

namespace {

std::string free_folder() {
  static std::atomic<int> number{0};
  return fmt::format("/vsimem/lsos_made_{}", ++number);
}

}  // namespace

MemoryFile::MemoryFile(const std::string& name)
    : folder_(free_folder()), name_(folder_ + "/" + name) {
  VSIMkdirRecursive(folder_.c_str(), 0700);
}

MemoryFile::~MemoryFile() { VSIRmdirRecursive(folder_.c_str()); }

std::string_view MemoryFile::bytes() const {
  vsi_l_offset size = 0;
  const GByte* begin = VSIGetMemFileBuffer(name_.c_str(), &size, false);
  return {reinterpret_cast<const char*>(begin), begin == nullptr ? 0 : size};
}

}  // namespace lsos
