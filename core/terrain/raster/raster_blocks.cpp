#include "terrain/raster/raster_blocks.h"

#include <gdal_priv.h>

#include <algorithm>

namespace lsos {

RasterBlocks spread_blocks(GDALRasterBand& band, std::int64_t most_cells) {
  int width = 0, height = 0;
  band.GetBlockSize(&width, &height);
  // A block of more than `most_cells` counts as lines of it.
  const std::int64_t lines = std::max<std::int64_t>(1, most_cells / width);
  height = static_cast<int>(std::min<std::int64_t>(height, lines));
  const std::int64_t across = (std::int64_t{band.GetXSize()} + width - 1) / width;
  const std::int64_t down = (std::int64_t{band.GetYSize()} + height - 1) / height;
  const std::int64_t count = across * down, cells = std::int64_t{width} * height;
  const std::int64_t read = std::clamp<std::int64_t>(most_cells / cells, 1, count);
  RasterBlocks result{{}, cells, read == count};
  for (std::int64_t i = 0; i < read; ++i) {
    // The middles of `read` equal parts are taken. The same columns of blocks would be hit again
    // and again if the step divided their number; this step is seldom a whole number.
    const std::int64_t k = (2 * i + 1) * count / (2 * read);
    const int column = static_cast<int>(k % across) * width;
    const int row = static_cast<int>(k / across) * height;
    result.blocks.push_back({column, row, std::min(width, band.GetXSize() - column),
                             std::min(height, band.GetYSize() - row)});
  }
  return result;
}

}  // namespace lsos
