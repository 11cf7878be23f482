#include "terrain/raster_hash.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <vector>

#include "base/error.h"
#include "terrain/gdal_call.h"

namespace lsos {

void add_samples(GDALRasterBand& band, Sha256& hash) {
  int has_nodata = FALSE;
  const double nodata = band.GetNoDataValue(&has_nodata);
  const GDALDataType type = band.GetRasterDataType();
  hash.add(fmt::format("{} x {} {} nodata {}", band.GetXSize(), band.GetYSize(),
                       GDALGetDataTypeName(type), has_nodata ? fmt::format("{}", nodata) : "-"));

  int width = 0;
  int height = 0;
  band.GetBlockSize(&width, &height);
  const std::int64_t across = (band.GetXSize() + width - 1) / width;
  const std::int64_t down = (band.GetYSize() + height - 1) / height;
  constexpr std::int64_t most_cells = std::int64_t{1} << 26;
  const std::int64_t cells = across * down * width * height;
  const std::int64_t stride = (cells + most_cells - 1) / most_cells;

  std::vector<char> block(static_cast<std::size_t>(width) * height *
                          GDALGetDataTypeSizeBytes(type));
  const GdalSilence silence;
  for (std::int64_t k = 0; k < across * down; k += stride) {
    // Blocks at the edge hold cells beyond the raster, which drivers leave as they were.
    std::fill(block.begin(), block.end(), 0);
    const int column = static_cast<int>(k % across) * width;
    const int row = static_cast<int>(k / across) * height;
    const int columns = std::min(width, band.GetXSize() - column);
    const int rows = std::min(height, band.GetYSize() - row);
    if (band.RasterIO(GF_Read, column, row, columns, rows, block.data(), columns, rows, type, 0, 0,
                      nullptr) != CE_None) {
      throw InputError({band.GetDataset()->GetDescription(), 0},
                       fmt::format("cannot be read: {}", GdalSilence::message()));
    }
    hash.add({block.data(), block.size()});
  }
}

}  // namespace lsos
