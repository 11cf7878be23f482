// A raster's own blocks, all of them or, of a large raster, a spread of them.
#pragma once

#include <cstdint>
#include <vector>

class GDALRasterBand;

namespace lsos {

struct RasterBlock {
  int column = 0;  // of its first cell
  int row = 0;
  int columns = 0;
  int rows = 0;
};

struct RasterBlocks {
  std::vector<RasterBlock> blocks;  // in reading order
  std::int64_t cells_max = 0;       // of the largest
  bool is_all = true;
};

// Blocks spread evenly over the raster, as many as keep to that many cells (or one block).
RasterBlocks spread_blocks(GDALRasterBand& band, std::int64_t most_cells);

}  // namespace lsos
