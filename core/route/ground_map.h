// The ground about a leg on a square lattice: what planning looks at, thousands of times a metre.
// Heights at full resolution, sampled as they are first asked for.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "terrain/ground.h"

namespace lsos {

// Horizontal plane at a place: x to the east, y to the north. Height is above the reference
// surface, so that level ground is level however far it reaches; over 10 km on the Moon places
// differ from those along the ground by 0.1 m.
class MapFrame {
 public:
  // `site` must outlive it.
  MapFrame(const SiteFrame& site, const Vec3& origin_S_m);

  // Where the local vertical through a point meets the plane.
  Vec2 at(const Vec3& p_S_m) const;
  // On the plane.
  Vec3 p_S_m(const Vec2& at_m) const;

 private:
  const SiteFrame* site_;
  Vec3 origin_S_m_, east_S_, north_S_, up_S_;
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
  // How far a place is from the map's edge; negative outside.
  double inside_m(const Vec2& at_m) const {
    const Vec2 high_m = place_m(columns_ - 1, rows_ - 1);
    return std::min((at_m - low_m_).minCoeff(), (high_m - at_m).minCoeff());
  }

  // Height of a node, 0 <= column < columns(), the same for rows; NaN where there is no ground.
  double node_m(int column, int row) {
    return tile(column >> tile_bits, row >> tile_bits)
        .height_m[index(column & tile_mask, row & tile_mask)];
  }
  // Between nodes bilinear; NaN outside and where there is no ground.
  double height_m(const Vec2& at_m) {
    const double u = (at_m.x() - low_m_.x()) * nodes_per_m_;
    const double v = (at_m.y() - low_m_.y()) * nodes_per_m_;
    if (!(u >= 0 && v >= 0 && u < columns_ - 1 && v < rows_ - 1)) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    const int column = static_cast<int>(u), row = static_cast<int>(v);
    const double x = u - column, y = v - row;
    const Tile& tile = this->tile(column >> tile_bits, row >> tile_bits);
    const float* low = &tile.height_m[index(column & tile_mask, row & tile_mask)];
    const float* high = low + tile_nodes;
    return (1 - y) * ((1 - x) * low[0] + x * low[1]) + y * ((1 - x) * high[0] + x * high[1]);
  }
  // How far a node about that place stands out over the mean of its neighbours, at most; nothing
  // less than that stands between places a few nodes apart.
  double bump_m(const Vec2& at_m);
  // Of the nearest node, which must be on the map.
  int soil(const Vec2& at_m);

  std::size_t sampled_nodes() const { return sampled_; }

 private:
  // Cells of a tile, and nodes: the last row and column are the first of the next tile's.
  static constexpr int tile_bits = 4, tile_mask = (1 << tile_bits) - 1;
  static constexpr int tile_nodes = (1 << tile_bits) + 1;
  struct Tile {
    std::array<float, std::size_t{tile_nodes} * tile_nodes> height_m;
    std::array<std::int32_t, std::size_t{tile_nodes} * tile_nodes> soil;
    double bump_m = 0;
  };

  static std::size_t index(int column, int row) {
    return static_cast<std::size_t>(row * tile_nodes + column);
  }
  const Tile& tile(int column, int row) {
    auto& tile =
        tiles_[static_cast<std::size_t>(row) * tile_columns_ + static_cast<std::size_t>(column)];
    if (!tile) tile = sampled(column, row);
    return *tile;
  }
  std::unique_ptr<Tile> sampled(int tile_column, int tile_row);

  Ground::Probe probe_;
  MapFrame frame_;
  Vec2 low_m_;
  double spacing_m_, nodes_per_m_;
  int columns_, rows_;
  std::size_t tile_columns_;
  std::vector<std::unique_ptr<Tile>> tiles_;
  std::size_t sampled_ = 0;
};

}  // namespace lsos
