#include "route/ground_map.h"

#include <cmath>

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
  sampled_ += tile->height_m.size();
  return tile;
}

int GroundMap::soil(const Vec2& at_m) {
  const Vec2 nodes = (at_m - low_m_) * nodes_per_m_;
  const int column = static_cast<int>(std::lround(nodes.x()));
  const int row = static_cast<int>(std::lround(nodes.y()));
  return tile(column >> tile_bits, row >> tile_bits)
      .soil[index(column & tile_mask, row & tile_mask)];
}

}  // namespace lsos
