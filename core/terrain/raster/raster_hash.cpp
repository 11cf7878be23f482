#include "terrain/raster/raster_hash.h"

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "base/error.h"
#include "terrain/raster/gdal_call.h"
#include "terrain/raster/raster_blocks.h"

namespace lsos {

namespace {

// 32 MB of 32-bit samples: half a second where they are compressed (measured: DEFLATE).
constexpr std::int64_t most_cells = std::int64_t{1} << 23;

// File of a band; "" for overviews that are part of another file.
const char* file_of(GDALRasterBand& band) {
  return band.GetDataset() != nullptr ? band.GetDataset()->GetDescription() : "";
}

// A change between the blocks that are read shows in the size of a compressed file at least.
void add_file_size(GDALRasterBand& band, Sha256& hash) {
  VSIStatBufL file;
  if (VSIStatL(file_of(band), &file) == 0) {
    hash.add(fmt::format("{} bytes", static_cast<std::int64_t>(file.st_size)));
  }
}

void add_some(GDALRasterBand& band, std::int64_t cells, Sha256& hash) {
  int has_nodata = FALSE;
  const double nodata = band.GetNoDataValue(&has_nodata);
  const GDALDataType type = band.GetRasterDataType();
  hash.add(fmt::format("{} x {} {} nodata {}", band.GetXSize(), band.GetYSize(),
                       GDALGetDataTypeName(type), has_nodata ? fmt::format("{}", nodata) : "-"));

  const RasterBlocks spread = spread_blocks(band, cells);
  if (!spread.is_all) add_file_size(band, hash);
  std::vector<char> block(static_cast<std::size_t>(spread.cells_max) *
                          GDALGetDataTypeSizeBytes(type));
  const GdalSilence silence;
  for (const RasterBlock& at : spread.blocks) {
    // Blocks at the edge hold cells beyond the raster, which drivers leave unchanged.
    std::fill(block.begin(), block.end(), 0);
    if (band.RasterIO(GF_Read, at.column, at.row, at.columns, at.rows, block.data(), at.columns,
                      at.rows, type, 0, 0, nullptr) != CE_None) {
      throw InputError({file_of(band), 0},
                       fmt::format("cannot be read: {}", GdalSilence::message()));
    }
    hash.add({block.data(), block.size()});
  }
}

}  // namespace

void add_samples(GDALRasterBand& band, Sha256& hash) { add_some(band, most_cells, hash); }
void add_overview(GDALRasterBand& band, Sha256& hash) { add_some(band, most_cells / 4, hash); }

void add_change(GDALRasterBand& band, Sha256& hash) {
  if (spread_blocks(band, most_cells).is_all) return;
  add_file_size(band, hash);
  std::error_code none;
  const auto changed = std::filesystem::last_write_time(file_of(band), none);
  if (!none) hash.add(fmt::format("changed {}", changed.time_since_epoch().count()));
}

}  // namespace lsos
