// The ground about a leg on a square lattice: what planning looks at, thousands of times a metre.
// Heights at full resolution, sampled as they are first asked for.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "terrain/ground.h"

namespace lsos {

// Horizontal plane at a place: x to the east, y to the north. Height is above the reference
// surface, so that level ground is level however far it reaches; over 10 km on the Moon places
// differ from those along the ground by 0.2 m.
class MapFrame {
 public:
  MapFrame(const SiteFrame& site, const Vec3& origin_S_m);

  Vec2 at(const Vec3& p_S_m) const;
  // On the plane.
  Vec3 p_S_m(const Vec2& at_m) const;

 private:
  Vec3 origin_S_m_, east_S_, north_S_;
};

struct MapNode {
  float height_m = 0;  // NaN: no ground
  std::int32_t soil = 0;
};

// One a thread.
class GroundMap {
 public:
  // Covers low_m..high_m. `spacing_m` > 0.
  GroundMap(const Ground& ground, const MapFrame& frame, const Vec2& low_m, const Vec2& high_m,
            double spacing_m);

  double spacing_m() const { return spacing_m_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const MapFrame& frame() const { return frame_; }
  Vec2 place_m(int column, int row) const {
    return low_m_ + spacing_m_ * Vec2(static_cast<double>(column), static_cast<double>(row));
  }
  const Vec2& low_m() const { return low_m_; }

  // 0 <= column < columns(), the same for rows.
  const MapNode& node(int column, int row) {
    auto& tile = tiles_[static_cast<std::size_t>(row >> tile_bits) * tile_columns_ +
                        static_cast<std::size_t>(column >> tile_bits)];
    if (!tile) tile = sampled(column >> tile_bits, row >> tile_bits);
    return (*tile)[static_cast<std::size_t>((row & tile_mask) << tile_bits | (column & tile_mask))];
  }
  // Between nodes bilinear; NaN outside and where there is no ground.
  double height_m(const Vec2& at_m);
  // Of the nearest node, which must be on the map.
  int soil(const Vec2& at_m);

  std::size_t sampled_nodes() const { return sampled_; }

 private:
  static constexpr int tile_bits = 5, tile_mask = (1 << tile_bits) - 1;
  using Tile = std::vector<MapNode>;
  std::unique_ptr<Tile> sampled(int tile_column, int tile_row);

  Ground::Probe probe_;
  MapFrame frame_;
  Vec2 low_m_;
  double spacing_m_;
  int columns_, rows_;
  std::size_t tile_columns_;
  std::vector<std::unique_ptr<Tile>> tiles_;
  std::size_t sampled_ = 0;
};

}  // namespace lsos
