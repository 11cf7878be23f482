// The local vertical by its series in cells of the site frame: wheels need it millions of times.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "planet/site_frame.h"

namespace lsos {

// Caches the cells last used. Use one object per thread; results never depend on the cache.
class VerticalCells {
 public:
  explicit VerticalCells(const SiteFrame& site) : site_(&site) {}

  // Vertical at a point, within 2e-10 m and 5e-15 rad of SiteFrame::vertical().
  Vertical at(const Vec3& p_S_m) {
    // Dynamics that diverge pass any point, also NaN; no cell has a number there.
    constexpr double farthest_m = 1e9;
    if (!(p_S_m.squaredNorm() < farthest_m * farthest_m)) return site_->vertical(p_S_m);
    const Cell& cell = cell_of(p_S_m);
    const Vec3 away_m = p_S_m - cell.centre_S_m;
    const double rise_m = cell.vertical.up_S.dot(away_m);
    // Higher up the vertical turns more slowly.
    const Vec3 turn = (1 - rise_m * cell.curvature_1pm) * (cell.turn_1pm * away_m);
    Vertical result;
    // Second order: `up_S` is shortened by the length that the turn adds.
    result.up_S = cell.vertical.up_S * (1 - 0.5 * turn.squaredNorm()) + turn;
    result.height_m = cell.vertical.height_m + rise_m + 0.5 * away_m.dot(turn);
    return result;
  }

 private:
  static constexpr double side_m = 8;
  struct Key {
    std::int64_t x = INT64_MIN, y = 0, z = 0;
    bool operator==(const Key&) const = default;
  };
  struct Cell {
    Key key;
    Vec3 centre_S_m;
    Vertical vertical;     // at the centre
    Mat3 turn_1pm;         // derivative of up by position
    double curvature_1pm;  // mean curvature of the surface through the centre
  };

  const Cell& cell_of(const Vec3& p_S_m) {
    const Key key{number(p_S_m.x()), number(p_S_m.y()), number(p_S_m.z())};
    Cell& cell = cells_[static_cast<std::size_t>(4 * (key.x & 1) + 2 * (key.y & 1) + (key.z & 1))];
    if (cell.key != key) cell = make_cell(key);
    return cell;
  }
  static std::int64_t number(double at_m) {
    const double cells = at_m / side_m;
    const auto truncated = static_cast<std::int64_t>(cells);
    return truncated - (static_cast<double>(truncated) > cells);
  }
  Cell make_cell(const Key& key) const;

  const SiteFrame* site_;
  // One cell for each parity of keys: wheels on both sides of a border keep theirs.
  std::array<Cell, 8> cells_;
};

}  // namespace lsos
