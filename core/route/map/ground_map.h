// Elevation map of the ground around a leg on a square lattice, which planning reads thousands of
// times for each metre of route. Heights have the full resolution of the terrain, but in a guide,
// and are sampled at first access.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "terrain/ground.h"

namespace lsos {

// Horizontal plane through a place: x east, y north, m. Heights are above the reference surface, so
// that level ground has the same height however far it extends. At 10 km on the Moon, positions on
// the plane differ from distances along the ground by 0.1 m.
class MapFrame {
 public:
  // `site` must outlive it.
  MapFrame(const SiteFrame& site, const Vec3& origin_S_m);

  // Point at which the local vertical through `p_S_m` meets the plane.
  Vec2 at(const Vec3& p_S_m) const;
  // Point of the plane in the site frame.
  Vec3 p_S_m(const Vec2& at_m) const;

 private:
  const SiteFrame* site_;
  Vec3 origin_S_m_, east_S_, north_S_, up_S_;
};

// Each thread needs a map of its own, since reading samples the ground.
class GroundMap {
 public:
  // Covers low_m..high_m. `spacing_m` > 0.
  GroundMap(const Ground& ground, const MapFrame& frame, const Vec2& low_m, const Vec2& high_m,
            double spacing_m);
  // Map of the same ground at `times` the spacing; `times` is a power of two. It has one in `times`
  // of the columns and rows of this map, and one more where the division leaves a remainder. Nodes
  // that this map has sampled are copied, so this map must outlive the new one.
  GroundMap coarser(int times) const;
  // The same without detail that is smaller than its spacing and without copies: a map that guides
  // a search over this one, in half of the time that all detail takes.
  GroundMap guide(int times) const;

  double spacing_m() const { return spacing_m_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const MapFrame& frame() const { return frame_; }
  Vec2 place_m(int column, int row) const {
    return low_m_ + spacing_m_ * Vec2(static_cast<double>(column), static_cast<double>(row));
  }
  const Vec2& low_m() const { return low_m_; }
  // Distance of a place from the map's edge, m; negative outside.
  double inside_m(const Vec2& at_m) const {
    const Vec2 high_m = place_m(columns_ - 1, rows_ - 1);
    return std::min((at_m - low_m_).minCoeff(), (high_m - at_m).minCoeff());
  }

  // Position in units of columns and rows, with fractions.
  Vec2 nodes(const Vec2& at_m) const { return (at_m - low_m_) * nodes_per_m_; }

  // Height of a node, 0 <= column < columns(), the same for rows; NaN where there is no ground.
  double node_m(int column, int row) {
    sampled_bump_m(column >> tile_bits, row >> tile_bits);
    return heights_m_[index(column, row)];
  }
  // Height by bilinear interpolation; NaN outside the map and where there is no ground.
  double height_m(const Vec2& at_m) {
    const double u = (at_m.x() - low_m_.x()) * nodes_per_m_;
    const double v = (at_m.y() - low_m_.y()) * nodes_per_m_;
    if (!(u >= 0 && v >= 0 && u < columns_ - 1 && v < rows_ - 1)) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    sampled_bump_m(static_cast<int>(u) >> tile_bits, static_cast<int>(v) >> tile_bits);
    return between(u, v);
  }
  // Soil of the nearest node, which must be on the map.
  int soil(const Vec2& at_m);

  // Part of the map whose heights are all sampled, for many look-ups without further checks.
  class Window {
   public:
    // Height as GroundMap::height_m(), at a position in nodes (see nodes()) that lies within the
    // window, or outside it by rounding only.
    double height_m(const Vec2& at) const { return map_->between(at.x(), at.y()); }
    // Height of a node of the window.
    double node_m(int column, int row) const { return map_->heights_m_[map_->index(column, row)]; }
    // Greatest height of a node in or near the window above the mean of its two neighbours in its
    // row or column, 0 at least. No rock much higher stands between places a few nodes apart.
    double bump_m() const { return bump_m_; }

   private:
    friend class GroundMap;
    Window(const GroundMap& map, double bump_m) : map_(&map), bump_m_(bump_m) {}
    const GroundMap* map_;
    double bump_m_;
  };
  // Window over the cells around first..last, in nodes; absent where some of them are not on the
  // map. It is `rounding` wider, since callers may compute a place on its edge with other last
  // digits.
  std::optional<Window> window(const Vec2& first, const Vec2& last) {
    const Vec2 low = first - Vec2::Constant(rounding), high = last + Vec2::Constant(rounding);
    const bool is_within =
        low.x() >= 0 && low.y() >= 0 && high.x() < columns_ - 1 && high.y() < rows_ - 1;
    if (!is_within) return std::nullopt;
    const int column_last = static_cast<int>(high.x()) >> tile_bits;
    const int row_last = static_cast<int>(high.y()) >> tile_bits;
    float bump_m = 0;
    for (int row = static_cast<int>(low.y()) >> tile_bits; row <= row_last; ++row) {
      for (int column = static_cast<int>(low.x()) >> tile_bits; column <= column_last; ++column) {
        bump_m = std::max(bump_m, sampled_bump_m(column, row));
      }
    }
    return Window(*this, bump_m);
  }

  std::size_t sampled_nodes() const { return sampled_; }

 private:
  // Number of cells along a side of a tile. Its nodes surround them: the last nodes of a tile are
  // the first of the next one.
  static constexpr int tile_bits = 3, tile_cells = 1 << tile_bits;
  static constexpr float not_sampled = -1;
  static constexpr double rounding = 1e-6;  // tolerance of positions, in nodes

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  double between(double u, double v) const {
    const int column = static_cast<int>(u), row = static_cast<int>(v);
    const double x = u - column, y = v - row;
    const float* low = &heights_m_[index(column, row)];
    const float* high = low + columns_;
    return (1 - y) * ((1 - x) * low[0] + x * low[1]) + y * ((1 - x) * high[0] + x * high[1]);
  }
  // Bump of a tile (see Window::bump_m()), which is sampled first where it is not yet.
  float sampled_bump_m(int tile_column, int tile_row) {
    float& bump_m = bumps_m_[static_cast<std::size_t>(tile_row) * tile_columns_ +
                             static_cast<std::size_t>(tile_column)];
    if (bump_m == not_sampled) bump_m = sample(tile_column, tile_row);
    return bump_m;
  }
  float sample(int tile_column, int tile_row);
  void sample_node(int column, int row);
  bool take_from_finer(int column, int row);

  const Ground* ground_;
  Ground::Probe probe_;
  MapFrame frame_;
  Vec2 low_m_;
  double spacing_m_, nodes_per_m_;
  int columns_, rows_;
  std::size_t tile_columns_;
  // Values of the nodes, row by row. Only sampled nodes have a value; the other memory is never
  // touched.
  std::unique_ptr<float[]> heights_m_;
  std::unique_ptr<std::uint16_t[]> soils_;
  std::vector<float> bumps_m_;  // by tile; not_sampled where it is not yet
  std::size_t sampled_ = 0;
  const GroundMap* finer_ = nullptr;
  int finer_times_ = 1;
};

}  // namespace lsos
