#include "terrain/raster_hash.h"

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "terrain/gdal_call.h"

namespace lsos {

namespace {

// 32 MB of 32-bit samples: half a second where they are compressed (measured: DEFLATE).
constexpr std::int64_t most_cells = std::int64_t{1} << 23;

struct Blocks {
  int width = 0, height = 0;  // in cells; a block wider than most_cells counts as lines of it
  std::int64_t across = 0, down = 0;
  std::int64_t count() const { return across * down; }
};

Blocks blocks_of(GDALRasterBand& band) {
  Blocks blocks;
  band.GetBlockSize(&blocks.width, &blocks.height);
  const std::int64_t lines = std::max<std::int64_t>(1, most_cells / blocks.width);
  blocks.height = static_cast<int>(std::min<std::int64_t>(blocks.height, lines));
  blocks.across = (band.GetXSize() + blocks.width - 1) / blocks.width;
  blocks.down = (band.GetYSize() + blocks.height - 1) / blocks.height;
  return blocks;
}

// A change between the blocks that are read shows in the size of a compressed file at least.
void add_file_size(const GDALRasterBand& band, Sha256& hash) {
  VSIStatBufL file;
  if (VSIStatL(const_cast<GDALRasterBand&>(band).GetDataset()->GetDescription(), &file) == 0) {
    hash.add(fmt::format("{} bytes", static_cast<std::int64_t>(file.st_size)));
  }
}

}  // namespace

void add_samples(GDALRasterBand& band, Sha256& hash) {
  int has_nodata = FALSE;
  const double nodata = band.GetNoDataValue(&has_nodata);
  const GDALDataType type = band.GetRasterDataType();
  hash.add(fmt::format("{} x {} {} nodata {}", band.GetXSize(), band.GetYSize(),
                       GDALGetDataTypeName(type), has_nodata ? fmt::format("{}", nodata) : "-"));

  const Blocks blocks = blocks_of(band);
  const std::int64_t cells = std::int64_t{blocks.width} * blocks.height;
  const std::int64_t read = std::clamp<std::int64_t>(most_cells / cells, 1, blocks.count());
  if (read < blocks.count()) add_file_size(band, hash);

  std::vector<char> block(static_cast<std::size_t>(cells) * GDALGetDataTypeSizeBytes(type));
  const GdalSilence silence;
  for (std::int64_t i = 0; i < read; ++i) {
    // The middles of `read` equal parts. Whole rows of blocks would be hit again and again if the
    // step divided their number; this step is seldom a whole number.
    const std::int64_t k = (2 * i + 1) * blocks.count() / (2 * read);
    // Blocks at the edge hold cells beyond the raster, which drivers leave as they were.
    std::fill(block.begin(), block.end(), 0);
    const int column = static_cast<int>(k % blocks.across) * blocks.width;
    const int row = static_cast<int>(k / blocks.across) * blocks.height;
    const int columns = std::min(blocks.width, band.GetXSize() - column);
    const int rows = std::min(blocks.height, band.GetYSize() - row);
    if (band.RasterIO(GF_Read, column, row, columns, rows, block.data(), columns, rows, type, 0, 0,
                      nullptr) != CE_None) {
      throw InputError({band.GetDataset()->GetDescription(), 0},
                       fmt::format("cannot be read: {}", GdalSilence::message()));
    }
    hash.add({block.data(), block.size()});
  }
}

}  // namespace lsos
