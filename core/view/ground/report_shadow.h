// Share of the Sun's disc that the ground of a map sees, for a whole mission in about a second.
// GroundLightProbe (view/exposure/ground_light.h) samples all directions of the disc at the
// ground's full detail; this marches along the Sun's azimuth over grids that get coarser with
// distance.
#pragma once

#include <vector>

#include "planet/sunlight.h"
#include "terrain/ground.h"

namespace lsos {

// Cells of a map in the site's frame, rows from the top.
struct MapCells {
  double left_m = 0, top_m = 0, cell_m = 1;
  int columns = 0, rows = 0;

  std::size_t size() const { return static_cast<std::size_t>(columns) * rows; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * columns + column;
  }
  // Centre of a cell.
  Vec3 p_S_m(int column, int row) const {
    return {left_m + (column + 0.5) * cell_m, top_m - (row + 0.5) * cell_m, 0};
  }
};

// How much of the detail below a raster is in the cells of a map. `shown`: all that a resolution
// shows, with nodes a sixteenth of it apart. `sparse`: with nodes a quarter of it apart, in a tenth
// of the time; a relief looks the same, shadows lose the smallest rims.
enum class MapDetail { shown, sparse };

// Elevation of each cell; NaN where there is no ground. `resolution_m`: resolution at which the
// ground is sampled, as Ground has it.
std::vector<double> elevations_m(const Ground& ground, const MapCells& cells, double resolution_m,
                                 int threads, MapDetail detail = MapDetail::shown);

// Share of the disc that each cell sees, 0..1; NaN where there is no ground.
std::vector<double> sunlit_shares(const Ground& ground, const MapCells& cells, Instant at,
                                  int threads);

}  // namespace lsos
