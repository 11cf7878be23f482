#include "terrain/raster/raster_spikes.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "base/units.h"
#include "terrain/grid/cell_sides.h"
#include "terrain/raster/gdal_call.h"

namespace lsos {

namespace {

// Greatest reach of a spike from its middle, in cells each way.
constexpr int widest = 2;
// A spike differs from every cell of a ring about it by more than this, plus what a slope of 76
// degrees rises over the ring's distance. Needles of rock on the Moon and Mars do not; on Earth
// masts, towers and trees do.
constexpr double least_m = 20, least_on_earth_m = 150, steepest = 4;
// Where a larger share is spikes, the ground is made so: by hand, or of buildings.
constexpr double most_share = 0.01;

class Window {
 public:
  Window(const RasterBlock& block, std::vector<double> heights)
      : at(block), heights_m(std::move(heights)) {}

  RasterBlock at;
  std::vector<double> heights_m;

  double operator()(int column, int row) const { return heights_m[index(column, row)]; }
  // Marks counted cells as missing, so that they count once.
  void mark_missing(int column, int row, int around) {
    for (int i = -around; i <= around; ++i) {
      for (int k = -around; k <= around; ++k) {
        heights_m[index(column + k, row + i)] = std::numeric_limits<double>::quiet_NaN();
      }
    }
  }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(at.columns) +
           static_cast<std::size_t>(column);
  }
};

// Height of a cell above all of the ring, m; negative: below; 0: neither, or the ring has holes.
double above_ring_m(const Window& window, int column, int row, int ring) {
  const double here = window(column, row);
  double above_m = std::numeric_limits<double>::infinity(), below_m = above_m;
  for (int i = -ring; i <= ring; ++i) {
    for (int k = -ring; k <= ring; ++k) {
      if (std::max(std::abs(i), std::abs(k)) != ring) continue;
      const double rise_m = here - window(column + k, row + i);
      if (std::isnan(rise_m)) return 0;
      above_m = std::min(above_m, rise_m);
      below_m = std::min(below_m, -rise_m);
    }
  }
  if (above_m > 0) return above_m;
  return below_m > 0 ? -below_m : 0;
}

// All of a small raster; for a large one four windows of as many cells, counted in whole blocks,
// for one cell of a block costs as much as all of it.
std::vector<RasterBlock> spread_windows(const Raster& raster) {
  constexpr std::int64_t most_cells = std::int64_t{1} << 20;  // of a window
  constexpr int least_rows = 16;
  const std::int64_t all = std::int64_t{raster.columns()} * raster.rows();
  if (all <= 4 * most_cells) return {{0, 0, raster.columns(), raster.rows()}};
  int block_width = 0, block_height = 0;
  raster.band().band().GetBlockSize(&block_width, &block_height);
  const int width = std::min(raster.columns(), std::max(1024, block_width));
  const int height =
      std::min(raster.rows(), std::max(least_rows, static_cast<int>(most_cells / width)));
  std::vector<RasterBlock> windows;
  for (const double row_share : {0.25, 0.75}) {
    for (const double column_share : {0.25, 0.75}) {
      const auto first = [](int cells, int size, double share) {
        return std::clamp(static_cast<int>(share * cells) - size / 2, 0, cells - size);
      };
      windows.push_back({first(raster.columns(), width, column_share),
                         first(raster.rows(), height, row_share), width, height});
      if (width == raster.columns()) break;
    }
  }
  return windows;
}

struct Spikes {
  int count = 0;         // places
  double cells = 0;      // examined
  double highest_m = 0;  // of the largest; negative: a pit
  GridCoordinates at{};  // cell of that one
};

void add_spikes(Window& window, double cell_m, double threshold_m, Spikes& spikes) {
  const int edge = widest + 1;
  for (int row = edge; row < window.at.rows - edge; ++row) {
    for (int column = edge; column < window.at.columns - edge; ++column) {
      for (int ring = 1; ring <= edge; ++ring) {
        const double least = threshold_m + steepest * ring * cell_m;
        // This first comparison seldom passes.
        const double beside_m = window(column, row) - window(column - ring, row);
        if (!(std::abs(beside_m) > least)) continue;
        const double above_m = above_ring_m(window, column, row, ring);
        if (!(std::abs(above_m) > least)) continue;
        ++spikes.count;
        if (std::abs(above_m) > std::abs(spikes.highest_m)) {
          spikes.highest_m = above_m;
          spikes.at = {static_cast<double>(window.at.column + column),
                       static_cast<double>(window.at.row + row)};
        }
        window.mark_missing(column, row, ring - 1);
        break;
      }
    }
  }
  spikes.cells += static_cast<double>(window.heights_m.size());
}

}  // namespace

std::string spike_advice(const Raster& raster, const RasterSurface& surface, const HeightGrid& grid,
                         const Body& body) {
  const GdalSilence silence;
  Spikes spikes;
  for (const RasterBlock& at : spread_windows(raster)) {
    const CellSides sides =
        cell_sides(grid, body, {at.column + at.columns / 2.0, at.row + at.rows / 2.0});
    const double cell_m = std::max(sides.along_row_m, sides.along_column_m);
    if (!std::isfinite(cell_m)) continue;
    Window window(at, raster.heights_m(at));
    add_spikes(window, cell_m, body.id == BodyId::earth ? least_on_earth_m : least_m, spikes);
  }
  if (spikes.count == 0 || spikes.count > most_share * spikes.cells) return {};
  const auto place = grid.place(spikes.at);
  if (!place) return {};
  return fmt::format(
      "raster '{}' leaps by {:.0f} m from one cell to the next and back at longitude {:.6g}, "
      "latitude {:.6g}{}: a fault of the map? It is taken as ground; mark such cells as missing "
      "({}), or mend them",
      surface.file, std::abs(spikes.highest_m), degrees(place->lon_rad), degrees(place->lat_rad),
      spikes.count == 1 ? "" : fmt::format(", and at {} more places", spikes.count - 1),
      option_of_raster("nodata"));
}

}  // namespace lsos
