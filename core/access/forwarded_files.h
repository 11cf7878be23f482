// A file system of GDAL that passes every call on to another; a check overrides what it checks.
#pragma once

#include <cpl_vsi_virtual.h>

namespace lsos {

class ForwardedFiles : public VSIFilesystemHandler {
 public:
  // `files` must outlive it.
  explicit ForwardedFiles(VSIFilesystemHandler* files) : files_(files) {}

  VSIVirtualHandle* Open(const char* path, const char* access, bool sets_error,
                         CSLConstList options) override {
    return files_->Open(path, access, sets_error, options);
  }
  int Stat(const char* path, VSIStatBufL* stat, int flags) override {
    return files_->Stat(path, stat, flags);
  }
  char** ReadDirEx(const char* folder, int files_max) override {
    return files_->ReadDirEx(folder, files_max);
  }
  char** SiblingFiles(const char* path) override { return files_->SiblingFiles(path); }
  VSIDIR* OpenDir(const char* folder, int depth, const char* const* options) override {
    return files_->OpenDir(folder, depth, options);
  }
  int Unlink(const char* path) override { return files_->Unlink(path); }
  int Rename(const char* from, const char* to) override { return files_->Rename(from, to); }
  int Mkdir(const char* folder, long mode) override { return files_->Mkdir(folder, mode); }
  int Rmdir(const char* folder) override { return files_->Rmdir(folder); }
  int IsCaseSensitive(const char* path) override { return files_->IsCaseSensitive(path); }
  GIntBig GetDiskFreeSpace(const char* folder) override { return files_->GetDiskFreeSpace(folder); }
  int SupportsSparseFiles(const char* path) override { return files_->SupportsSparseFiles(path); }
  bool IsLocal(const char* path) override { return files_->IsLocal(path); }
  bool SupportsSequentialWrite(const char* path, bool may_be_temporary) override {
    return files_->SupportsSequentialWrite(path, may_be_temporary);
  }
  bool SupportsRandomWrite(const char* path, bool may_be_temporary) override {
    return files_->SupportsRandomWrite(path, may_be_temporary);
  }

 protected:
  VSIFilesystemHandler& files() { return *files_; }

 private:
  VSIFilesystemHandler* files_;
};

}  // namespace lsos
