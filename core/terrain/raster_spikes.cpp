#include "terrain/raster_spikes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/units.h"
#include "terrain/cell_sides.h"
#include "terrain/gdal_call.h"

namespace lsos {

namespace {

// A spike is at most so many cells wide each way from its middle.
constexpr int widest = 2;
// It differs from every cell of a ring about it by more than so much, and by more than a slope of
// 76 degrees does over the ring's distance. Needles of rock on the Moon and Mars do not.
constexpr double least_m = 20, steepest = 4;
// A cell in so many, and the ground is made so: by hand, or of buildings.
constexpr double most_share = 0.01;

struct Window {
  RasterBlock at;
  std::vector<double> heights_m;

  double operator()(int column, int row) const {
    return heights_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(at.columns) +
                     static_cast<std::size_t>(column)];
  }
};

// How far a cell stands above all of the ring, negative: below; 0: neither, or the ring is not
// whole.
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

// All of a small raster, and squares spread over a large one.
std::vector<RasterBlock> spread_windows(const Raster& raster) {
  constexpr int side = 1024, across = 2;
  std::vector<RasterBlock> windows;
  const auto parts = [](int cells) { return cells <= across * side ? 1 : across; };
  const int columns = parts(raster.columns()), rows = parts(raster.rows());
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < columns; ++k) {
      const auto part = [](int cells, int count, int at) {
        const int size = count == 1 ? cells : side;
        const int middle = cells * (2 * at + 1) / (2 * count);
        return std::pair{middle - size / 2, size};
      };
      const auto [column, width] = part(raster.columns(), columns, k);
      const auto [row, height] = part(raster.rows(), rows, i);
      windows.push_back({column, row, width, height});
    }
  }
  return windows;
}

struct Spikes {
  int count = 0;
  double cells = 0;      // looked at
  double highest_m = 0;  // of the largest, negative: a pit
  GridCoordinates at{};  // of that one
};

void add_spikes(const Window& window, double cell_m, Spikes& spikes) {
  const int edge = widest + 1;
  for (int row = edge; row < window.at.rows - edge; ++row) {
    for (int column = edge; column < window.at.columns - edge; ++column) {
      const double here = window(column, row);
      // Every spike has a cell that differs so from the one on its left.
      if (!(std::abs(here - window(column - 1, row)) > least_m + steepest * cell_m)) continue;
      for (int ring = 1; ring <= edge; ++ring) {
        const double above_m = above_ring_m(window, column, row, ring);
        if (!(std::abs(above_m) > least_m + steepest * ring * cell_m)) continue;
        ++spikes.count;
        if (std::abs(above_m) > std::abs(spikes.highest_m)) {
          spikes.highest_m = above_m;
          spikes.at = {static_cast<double>(window.at.column + column),
                       static_cast<double>(window.at.row + row)};
        }
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
    if (std::isfinite(cell_m)) add_spikes({at, raster.heights_m(at)}, cell_m, spikes);
  }
  if (spikes.count == 0 || spikes.count > most_share * spikes.cells) return {};
  const auto place = grid.place(spikes.at);
  if (!place) return {};
  return fmt::format(
      "raster '{}' leaps by {:.0f} m from one cell to the next and back at longitude {:.6g}, "
      "latitude {:.6g}{}: a fault of the map? It is taken as ground; mark such cells as missing "
      "({}), or mend them",
      surface.file, std::abs(spikes.highest_m), degrees(place->lon_rad), degrees(place->lat_rad),
      spikes.count == 1 ? "" : fmt::format(", and at {} more cells", spikes.count - 1),
      option_of_raster("nodata"));
}

}  // namespace lsos
