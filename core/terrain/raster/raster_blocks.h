// A raster's own blocks: all of them or, for a large raster, a spread of them.
#pragma once

#include <cstdint>
#include <vector>

class GDALRasterBand;

namespace lsos {

struct RasterBlock {
  int column = 0;  // column of its first cell
  int row = 0;
  int columns = 0;
  int rows = 0;
};

struct RasterBlocks {
  std::vector<RasterBlock> blocks;  // in reading order
  std::int64_t cells_max = 0;       // cells of the largest block
  bool is_all = true;
};

// Blocks spread evenly over the raster, with at most `most_cells` cells together (or one block).
RasterBlocks spread_blocks(GDALRasterBand& band, std::int64_t most_cells);

}  // namespace lsos
