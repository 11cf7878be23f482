#include "route/ground_map.h"

#include <cmath>
#include <limits>

namespace lsos {

MapFrame::MapFrame(const SiteFrame& site, const Vec3& origin_S_m)
    : origin_S_m_(origin_S_m),
      east_S_(site.east_S(origin_S_m)),
      north_S_(site.north_S(origin_S_m)) {}

Vec2 MapFrame::at(const Vec3& p_S_m) const {
  const Vec3 from_m = p_S_m - origin_S_m_;
  return {from_m.dot(east_S_), from_m.dot(north_S_)};
}

Vec3 MapFrame::p_S_m(const Vec2& at_m) const {
  return origin_S_m_ + at_m.x() * east_S_ + at_m.y() * north_S_;
}

GroundMap::GroundMap(const Ground& ground, const MapFrame& frame, const Vec2& low_m,
                     const Vec2& high_m, double spacing_m)
    : probe_(ground),
      frame_(frame),
      low_m_(low_m),
      spacing_m_(spacing_m),
      columns_(static_cast<int>(std::ceil((high_m.x() - low_m.x()) / spacing_m)) + 1),
      rows_(static_cast<int>(std::ceil((high_m.y() - low_m.y()) / spacing_m)) + 1),
      tile_columns_(static_cast<std::size_t>((columns_ >> tile_bits) + 1)),
      tiles_(tile_columns_ * static_cast<std::size_t>((rows_ >> tile_bits) + 1)) {}

std::unique_ptr<GroundMap::Tile> GroundMap::sampled(int tile_column, int tile_row) {
  constexpr int side = 1 << tile_bits;
  auto tile = std::make_unique<Tile>();
  tile->reserve(static_cast<std::size_t>(side * side));
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const Vec2 at_m = place_m(tile_column * side + column, tile_row * side + row);
      const GroundSample sample = probe_.sample(frame_.p_S_m(at_m));
      tile->push_back({static_cast<float>(sample.elevation_m), sample.soil});
    }
  }
  sampled_ += tile->size();
  return tile;
}

double GroundMap::height_m(const Vec2& at_m) {
  const double u = (at_m.x() - low_m_.x()) / spacing_m_, v = (at_m.y() - low_m_.y()) / spacing_m_;
  if (!(u >= 0 && v >= 0 && u < columns_ - 1 && v < rows_ - 1)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const int column = static_cast<int>(u), row = static_cast<int>(v);
  const double x = u - column, y = v - row;
  const auto between = [&](double low_left, double low_right, double high_left, double high_right) {
    return (1 - y) * ((1 - x) * low_left + x * low_right) +
           y * ((1 - x) * high_left + x * high_right);
  };
  // All four in one tile but for its last column and row.
  if ((column & tile_mask) < tile_mask && (row & tile_mask) < tile_mask) {
    const MapNode* low = &node(column, row);
    const MapNode* high = low + (1 << tile_bits);
    return between(low[0].height_m, low[1].height_m, high[0].height_m, high[1].height_m);
  }
  return between(node(column, row).height_m, node(column + 1, row).height_m,
                 node(column, row + 1).height_m, node(column + 1, row + 1).height_m);
}

int GroundMap::soil(const Vec2& at_m) {
  const Vec2 cells = (at_m - low_m_) / spacing_m_;
  return node(static_cast<int>(std::lround(cells.x())), static_cast<int>(std::lround(cells.y())))
      .soil;
}

}  // namespace lsos
