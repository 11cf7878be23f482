// Points at random places of a plane: the same for the same key, whichever part is computed.
#pragma once

#include <cmath>
#include <cstdint>

#include "base/random.h"
#include "terrain/grid/site_plane.h"

namespace lsos {

struct PlaneRectangle {
  PlanePoint low;
  PlanePoint high;
};

// Random number of points of a Poisson process with this mean; any mean that is not negative.
int poisson_count(double mean, RandomStream& random);

// Calls `visit(point, random)` for each point of the Poisson process with `mean_pm2` points per m2
// that may lie in the rectangle, in a fixed order. Each square of `cell_m` has a stream of its own,
// keyed by its place; `visit` draws its marks from it.
template <class Visit>
void visit_points(std::uint64_t key, double mean_pm2, double cell_m, const PlaneRectangle& in,
                  const Visit& visit) {
  const auto cell = [cell_m](double at_m) {
    return static_cast<std::int64_t>(std::floor(at_m / cell_m));
  };
  for (std::int64_t row = cell(in.low.y_m); row <= cell(in.high.y_m); ++row) {
    for (std::int64_t column = cell(in.low.x_m); column <= cell(in.high.x_m); ++column) {
      RandomStream random(mix_key(mix_key(key, static_cast<std::uint64_t>(column)),
                                  static_cast<std::uint64_t>(row)));
      for (int rest = poisson_count(mean_pm2 * cell_m * cell_m, random); rest > 0; --rest) {
        PlanePoint at;
        at.x_m = (static_cast<double>(column) + random.uniform()) * cell_m;
        at.y_m = (static_cast<double>(row) + random.uniform()) * cell_m;
        visit(at, random);
      }
    }
  }
}

}  // namespace lsos
