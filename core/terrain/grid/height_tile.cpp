#include "terrain/grid/height_tile.h"

#include <limits>

#include "base/vector.h"

namespace lsos {

namespace {

// Weights of nodes in the value and in the slope, side by side: the processor does both at once.
struct Weights {
  Vec2 of[4];
};

// Catmull-Rom weights of the nodes at -1, 0, 1, 2 for a point at t in [0, 1).
inline Weights catmull_rom(double t) {
  const double t2 = t * t;
  const double t3 = t2 * t;
  return {{{0.5 * (2 * t2 - t3 - t), 0.5 * (4 * t - 3 * t2 - 1)},
           {0.5 * (3 * t3 - 5 * t2) + 1, 0.5 * (9 * t2 - 10 * t)},
           {0.5 * (4 * t2 - 3 * t3 + t), 0.5 * (8 * t - 9 * t2 + 1)},
           {0.5 * (t3 - t2), 0.5 * (3 * t2 - 2 * t)}}};
}

}  // namespace

SurfaceHeight surface_height(const HeightTile& tile, const CellPoint& at) {
  const int i = static_cast<int>(at.column & (HeightTile::cells - 1));
  const int j = static_cast<int>(at.row & (HeightTile::cells - 1));
  if (!tile.is_ground(i, j)) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none};
  }
  const Weights u = catmull_rom(at.along_u);
  const Weights v = catmull_rom(at.along_v);
  // Heights are taken relative to one node, so that the weights' rounding does not grow with the
  // elevation: a level surface stays level to the last bit.
  const double datum_m = tile.height_m(i, j);
  Vec2 height_and_by_u = Vec2::Zero();
  double by_v = 0;
  for (int k = 0; k < 4; ++k) {
    const double* row_m = tile.row_m(i - 1, j - 1 + k);
    const Vec2 along_row = (u.of[0] * (row_m[0] - datum_m) + u.of[1] * (row_m[1] - datum_m)) +
                           (u.of[2] * (row_m[2] - datum_m) + u.of[3] * (row_m[3] - datum_m));
    height_and_by_u += v.of[k].x() * along_row;
    by_v += v.of[k].y() * along_row.x();
  }
  return {height_and_by_u.x() + datum_m, height_and_by_u.y(), by_v};
}

}  // namespace lsos
