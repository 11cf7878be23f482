#include "planet/vertical_cells.h"

namespace lsos {

VerticalCells::Cell VerticalCells::make_cell(const Key& key) const {
  // Differences over 10 m lose no digits that count, and the turn is uniform over it to 1e-11.
  constexpr double step_m = 10;
  Cell cell;
  cell.key = key;
  cell.centre_S_m = side_m * (Vec3(static_cast<double>(key.x), static_cast<double>(key.y),
                                   static_cast<double>(key.z)) +
                              Vec3::Constant(0.5));
  cell.vertical = site_->vertical(cell.centre_S_m);
  for (int i = 0; i < 3; ++i) {
    const Vec3 aside_m = step_m * Vec3::Unit(i);
    cell.turn_1pm.col(i) =
        (site_->up_S(cell.centre_S_m + aside_m) - site_->up_S(cell.centre_S_m - aside_m)) /
        (2 * step_m);
  }
  cell.curvature_1pm = cell.turn_1pm.trace() / 2;
  return cell;
}

}  // namespace lsos
