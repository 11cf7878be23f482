// Files that a raster is read from, as they were when it was opened: a run reads them for hours.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

class GDALDataset;

namespace lsos {

class FilesAsOpened {
 public:
  // The dataset's own files, sources of a VRT among them; statistics beside a raster, which viewers
  // write, do not count. The files of a dataset in an archive are the archive.
  explicit FilesAsOpened(GDALDataset& dataset);
  // Files that have been written, replaced or removed since, sorted.
  std::vector<std::string> changed() const;

 private:
  struct State {
    std::uint64_t device = 0, inode = 0;
    std::int64_t size_bytes = 0, written_ns = 0;
    bool operator==(const State&) const = default;
  };
  static State state_of(const std::string& file);

  std::vector<std::pair<std::string, State>> files_;
};

}  // namespace lsos
