#include "route/ground_map.h"

#include <algorithm>
#include <cmath>

namespace lsos {

MapFrame::MapFrame(const SiteFrame& site, const Vec3& origin_S_m)
    : site_(&site),
      origin_S_m_(origin_S_m),
      east_S_(site.east_S(origin_S_m)),
      north_S_(site.north_S(origin_S_m)),
      up_S_(north_S_.cross(-east_S_)) {}

Vec2 MapFrame::at(const Vec3& p_S_m) const {
  const Vec3 vertical_S = site_->up_S(p_S_m), from_m = p_S_m - origin_S_m_;
  const Vec3 on_m = from_m - from_m.dot(up_S_) / vertical_S.dot(up_S_) * vertical_S;
  return {on_m.dot(east_S_), on_m.dot(north_S_)};
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
      nodes_per_m_(1 / spacing_m),
      columns_(static_cast<int>(std::ceil((high_m.x() - low_m.x()) / spacing_m)) + 1),
      rows_(static_cast<int>(std::ceil((high_m.y() - low_m.y()) / spacing_m)) + 1),
      tile_columns_(static_cast<std::size_t>((columns_ >> tile_bits) + 1)),
      tiles_(tile_columns_ * static_cast<std::size_t>((rows_ >> tile_bits) + 1)) {}

std::unique_ptr<GroundMap::Tile> GroundMap::sampled(int tile_column, int tile_row) {
  auto tile = std::make_unique<Tile>();
  for (int row = 0; row < tile_nodes; ++row) {
    for (int column = 0; column < tile_nodes; ++column) {
      const Vec2 at_m = place_m((tile_column << tile_bits) + column, (tile_row << tile_bits) + row);
      const GroundSample sample = probe_.sample(frame_.p_S_m(at_m));
      tile->height_m[index(column, row)] = static_cast<float>(sample.elevation_m);
      tile->soil[index(column, row)] = sample.soil;
    }
  }
  // Along its edges only the neighbours on them: a rock stands out over any two.
  const auto over = [&](int row, int column, int rows, int columns) {
    const float here_m = tile->height_m[index(column, row)];
    return here_m - (tile->height_m[index(column - columns, row - rows)] +
                     tile->height_m[index(column + columns, row + rows)]) /
                        2;
  };
  for (int row = 0; row < tile_nodes; ++row) {
    for (int column = 0; column < tile_nodes; ++column) {
      const bool is_within_rows = row > 0 && row + 1 < tile_nodes;
      const bool is_within_columns = column > 0 && column + 1 < tile_nodes;
      double bump_m = 0;
      if (is_within_rows) bump_m = std::max<double>(bump_m, over(row, column, 1, 0));
      if (is_within_columns) bump_m = std::max<double>(bump_m, over(row, column, 0, 1));
      tile->bump_m = std::max(tile->bump_m, bump_m);
    }
  }
  sampled_ += tile->height_m.size();
  return tile;
}

double GroundMap::bump_m(const Vec2& at_m) {
  const Vec2 nodes = (at_m - low_m_) * nodes_per_m_;
  const int column = std::clamp(static_cast<int>(nodes.x()), 0, columns_ - 1);
  const int row = std::clamp(static_cast<int>(nodes.y()), 0, rows_ - 1);
  return tile(column >> tile_bits, row >> tile_bits).bump_m;
}

int GroundMap::soil(const Vec2& at_m) {
  const Vec2 nodes = (at_m - low_m_) * nodes_per_m_;
  const int column = static_cast<int>(std::lround(nodes.x()));
  const int row = static_cast<int>(std::lround(nodes.y()));
  return tile(column >> tile_bits, row >> tile_bits)
      .soil[index(column & tile_mask, row & tile_mask)];
}

}  // namespace lsos
