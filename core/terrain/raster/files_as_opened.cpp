#include "terrain/raster/files_as_opened.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <sys/stat.h>

#include <set>

#include "access/file_access.h"

namespace lsos {

FilesAsOpened::State FilesAsOpened::state_of(const std::string& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) return {};
  return {found.st_dev, found.st_ino, found.st_size,
          std::int64_t{found.st_mtim.tv_sec} * 1'000'000'000 + found.st_mtim.tv_nsec};
}

FilesAsOpened::FilesAsOpened(GDALDataset& dataset) {
  const CPLStringList names(dataset.GetFileList());
  std::set<std::string> files;
  for (int i = 0; i < names.size(); ++i) {
    const std::string name = names[i];
    if (!name.ends_with(".aux.xml")) files.insert(file_on_disk(name));
  }
  for (const std::string& file : files) files_.emplace_back(file, state_of(file));
}

std::vector<std::string> FilesAsOpened::changed() const {
  std::vector<std::string> changed;
  for (const auto& [file, state] : files_) {
    if (state_of(file) != state) changed.push_back(file);
  }
  return changed;
}

}  // namespace lsos
