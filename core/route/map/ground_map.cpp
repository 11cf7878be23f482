#include "route/map/ground_map.h"

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
    : ground_(&ground),
      probe_(ground),
      frame_(frame),
      low_m_(low_m),
      spacing_m_(spacing_m),
      nodes_per_m_(1 / spacing_m),
      columns_(static_cast<int>(std::ceil((high_m.x() - low_m.x()) / spacing_m)) + 1),
      rows_(static_cast<int>(std::ceil((high_m.y() - low_m.y()) / spacing_m)) + 1),
      tile_columns_(static_cast<std::size_t>((columns_ >> tile_bits) + 1)),
      heights_m_(std::make_unique_for_overwrite<float[]>(index(0, rows_))),
      soils_(std::make_unique_for_overwrite<std::uint16_t[]>(index(0, rows_))),
      bumps_m_(tile_columns_ * static_cast<std::size_t>((rows_ >> tile_bits) + 1), not_sampled) {}

GroundMap GroundMap::coarser(int times) const {
  GroundMap map(*ground_, frame_, low_m_, place_m(columns_ - 1, rows_ - 1), times * spacing_m_);
  map.finer_ = this;
  map.finer_times_ = times;
  return map;
}

GroundMap GroundMap::guide(int times) const {
  GroundMap map(*ground_, frame_, low_m_, place_m(columns_ - 1, rows_ - 1), times * spacing_m_);
  map.probe_ = Ground::Probe::with_sparse_detail(*ground_, map.spacing_m_);
  return map;
}

// A copy is bit-identical to a new sample: scaling by a power of two is exact, so that both maps
// have the node at the same place.
bool GroundMap::take_from_finer(int column, int row) {
  if (finer_ == nullptr) return false;
  const int x = finer_times_ * column, y = finer_times_ * row;
  if (x >= finer_->columns_ || y >= finer_->rows_) return false;
  const std::size_t tile = static_cast<std::size_t>(y >> tile_bits) * finer_->tile_columns_ +
                           static_cast<std::size_t>(x >> tile_bits);
  if (finer_->bumps_m_[tile] == not_sampled) return false;
  heights_m_[index(column, row)] = finer_->heights_m_[finer_->index(x, y)];
  soils_[index(column, row)] = finer_->soils_[finer_->index(x, y)];
  return true;
}

void GroundMap::sample_node(int column, int row) {
  if (take_from_finer(column, row)) return;
  const GroundSample sample = probe_.sample(frame_.p_S_m(place_m(column, row)));
  heights_m_[index(column, row)] = static_cast<float>(sample.elevation_m);
  soils_[index(column, row)] = static_cast<std::uint16_t>(sample.soil);
  ++sampled_;
}

float GroundMap::sample(int tile_column, int tile_row) {
  const int column_first = tile_column << tile_bits, row_first = tile_row << tile_bits;
  const int column_last = std::min(column_first + tile_cells, columns_ - 1);
  const int row_last = std::min(row_first + tile_cells, rows_ - 1);
  for (int row = row_first; row <= row_last; ++row) {
    for (int column = column_first; column <= column_last; ++column) sample_node(column, row);
  }
  // Nodes on an edge of the tile are compared with their neighbours along that edge only; a rock
  // stands above any two neighbours.
  const auto over = [&](std::size_t at, std::size_t apart) {
    return heights_m_[at] - (heights_m_[at - apart] + heights_m_[at + apart]) / 2;
  };
  float bump_m = 0;
  for (int row = row_first; row <= row_last; ++row) {
    for (int column = column_first; column <= column_last; ++column) {
      const std::size_t at = index(column, row);
      const bool is_within_rows = row > row_first && row < row_last;
      const bool is_within_columns = column > column_first && column < column_last;
      if (is_within_rows) bump_m = std::max(bump_m, over(at, static_cast<std::size_t>(columns_)));
      if (is_within_columns) bump_m = std::max(bump_m, over(at, 1));
    }
  }
  return bump_m;
}

int GroundMap::soil(const Vec2& at_m) {
  const Vec2 at = nodes(at_m);
  const int column = static_cast<int>(std::lround(at.x()));
  const int row = static_cast<int>(std::lround(at.y()));
  sampled_bump_m(column >> tile_bits, row >> tile_bits);
  return soils_[index(column, row)];
}

}  // namespace lsos
