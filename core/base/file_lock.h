// Keeps other processes out while a file is held.
#pragma once

#include <string>

namespace lsos {

class FileLock {
 public:
  // Waits until no other process holds the file, which must exist. Where it cannot be opened or
  // locked, as on some network drives, nothing is held.
  explicit FileLock(const std::string& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace lsos
