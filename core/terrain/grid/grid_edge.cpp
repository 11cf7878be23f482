#include "terrain/grid/grid_edge.h"

#include <cmath>

namespace lsos {

std::vector<Geodetic> places_along_edge(const HeightGrid& grid, double outside_cells) {
  const GridExtent& extent = grid.extent();
  std::vector<Geodetic> places;
  const auto add = [&](double u, double v) {
    if (const auto place = grid.place({u, v})) places.push_back(*place);
  };
  constexpr int sides = 16;
  for (int k = 0; k <= sides; ++k) {
    const double share = static_cast<double>(k) / sides;
    const double u = std::lerp(extent.u_low, extent.u_high, share);
    const double v = std::lerp(extent.v_low, extent.v_high, share);
    if (!extent.goes_around()) {
      add(extent.u_low - outside_cells, v);
      add(extent.u_high + outside_cells, v);
    }
    add(u, extent.v_low - outside_cells);
    add(u, extent.v_high + outside_cells);
  }
  return places;
}

}  // namespace lsos
