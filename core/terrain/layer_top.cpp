// Upper bounds on the ground of a layer, from those of its tiles.
#include <algorithm>
#include <cmath>

#include "base/rounding.h"
#include "terrain/layer.h"

namespace lsos {

namespace {

// A region over more squares than this is not examined.
constexpr std::int64_t squares_max = 64;

}  // namespace

std::shared_ptr<const TileTop> Layer::top(const TileKey& key) {
  return tops_.get(key, [this](const TileKey& wanted) { return tile_top(*tile(wanted)); });
}

std::shared_ptr<const TileTop> Layer::detail_top(const TileKey& key) {
  return detail_tops_.get(key,
                          [this](const TileKey& wanted) { return tile_top(*detail_tile(wanted)); });
}

// Part of a region that lies inside the grid's extent.
struct Layer::Probe::GridBox {
  double u_low, u_high, v_low, v_high;
  bool is_whole = true;  // no part of the region lies outside

  SquareRange squares(int level) const {
    return SquareRange::between(CellPoint(on_level(u_low, level), on_level(v_low, level)),
                                CellPoint(on_level(u_high, level), on_level(v_high, level)));
  }
};

std::optional<Layer::Probe::GridBox> Layer::Probe::box(std::span<const PlanePoint> corners) {
  GridBox box{infinite, -infinite, infinite, -infinite};
  std::optional<GridPoint> first;
  double bend = 0;  // of the map over the region: by how much corners miss the linear map, in cells
  for (const PlanePoint& corner : corners) {
    const std::optional<GridPoint> at = grid_point(corner);
    if (!at) return {};
    if (!first) first = at;
    const double x_m = corner.x_m - corners[0].x_m, y_m = corner.y_m - corners[0].y_m;
    bend = std::max({bend, std::abs(first->u + first->u_by_x * x_m + first->u_by_y * y_m - at->u),
                     std::abs(first->v + first->v_by_x * x_m + first->v_by_y * y_m - at->v)});
    box.u_low = std::min(box.u_low, at->u);
    box.u_high = std::max(box.u_high, at->u);
    box.v_low = std::min(box.v_low, at->v);
    box.v_high = std::max(box.v_high, at->v);
  }
  // The region's sides may bulge on the grid, by less than its corners miss the linear map. Where
  // they miss it by more, a pole of the grid may lie in the region, or the seam of its columns.
  constexpr double bulge = 0.05;
  const double margin = bulge * std::max(box.u_high - box.u_low, box.v_high - box.v_low);
  if (!(bend <= margin)) return {};
  box.u_low -= margin;
  box.u_high += margin;
  box.v_low -= margin;
  box.v_high += margin;
  const GridExtent& extent = layer_->grid_->extent();
  if (extent.period > 0) {
    const double turns = std::floor((box.u_low - extent.u_low) / extent.period);
    box.u_low -= turns * extent.period;
    box.u_high -= turns * extent.period;
    // Columns beyond the seam have other numbers.
    if (box.u_high > extent.u_low + extent.period) return {};
  }
  const GridBox all = box;
  box.u_low = std::max(box.u_low, extent.u_low);
  box.u_high = std::min(box.u_high, extent.u_high);
  box.v_low = std::max(box.v_low, extent.v_low);
  box.v_high = std::min(box.v_high, extent.v_high);
  box.is_whole = all.u_low == box.u_low && all.u_high == box.u_high && all.v_low == box.v_low &&
                 all.v_high == box.v_high;
  return box;
}

bool Layer::Probe::is_alone(const GridBox& box) {
  if (!layer_->fades_) return box.is_whole;
  if (!box.is_whole) return false;
  const int level = level_of_detail_.level;
  const TileKey low = CellPoint(on_level(box.u_low, level), on_level(box.v_low, level)).tile();
  const TileKey high = CellPoint(on_level(box.u_high, level), on_level(box.v_high, level)).tile();
  for (std::int64_t row = low.row; row <= high.row; ++row) {
    for (std::int64_t column = low.column; column <= high.column; ++column) {
      const WeightTile& weights = weights_.get({column, row, level}, [this](const TileKey& wanted) {
        return layer_->weight_tile(wanted);
      });
      if (!weights.is_whole) return false;
    }
  }
  return true;
}

// Bound from the heights at the corners, without detail: closer where a region has few cells.
double Layer::Probe::corner_bound_m(const GridBox& box, const Vec2& bend_m) {
  const int level = level_of_detail_.level;
  double highest_m = -std::numeric_limits<double>::infinity();
  for (const double u : {box.u_low, box.u_high}) {
    for (const double v : {box.v_low, box.v_high}) {
      const CellPoint cell(on_level(u, level), on_level(v, level));
      TileKey key = cell.tile();
      key.level = level;
      const HeightTile& tile =
          tiles_.get(key, [this](const TileKey& wanted) { return layer_->tile(wanted); });
      highest_m = std::max(highest_m, surface_height(tile, cell).height_m);
    }
  }
  return highest_m + greatest_bulge_m(bend_m, std::ldexp(box.u_high - box.u_low, -level),
                                      std::ldexp(box.v_high - box.v_low, -level));
}

std::optional<LayerTop> Layer::Probe::top(std::span<const PlanePoint> corners) {
  const std::optional<GridBox> box = this->box(corners);
  if (!box) return {};
  LayerTop top;
  if (box->u_low > box->u_high || box->v_low > box->v_high) {
    top.ground.is_whole = false;
    return top;
  }
  const SquareRange range = box->squares(level_of_detail_.level);
  if (range.size() > squares_max) return {};
  top.ground = highest_ground(
      range, level_of_detail_.level, [this](const TileKey& key) -> auto& {
        return tops_.get(key, [this](const TileKey& wanted) { return layer_->top(wanted); });
      });
  if (top.ground.is_whole) {
    top.ground.highest_m = std::min(top.ground.highest_m, corner_bound_m(*box, top.ground.bend_m));
  }
  top.ground.is_whole &= box->is_whole;
  top.is_alone = top.ground.is_whole && is_alone(*box);
  if (!level_of_detail_.has_detail || layer_->detail_ == nullptr) return top;

  const double per_cell =
      std::ldexp(layer_->detail_->subdivision(), -level_of_detail_.detail_level);
  const auto fine = [&](double u) { return (u + 0.5) * per_cell; };
  const SquareRange fine_range =
      SquareRange::between(CellPoint(fine(box->u_low), fine(box->v_low)),
                           CellPoint(fine(box->u_high), fine(box->v_high)));
  if (fine_range.size() > squares_max) return {};
  const HighestGround detail = highest_ground(
      fine_range, level_of_detail_.detail_level, [this](const TileKey& key) -> auto& {
        return detail_tops_.get(
            key, [this](const TileKey& wanted) { return layer_->detail_top(wanted); });
      });
  top.ground.highest_m += detail.highest_m;
  return top;
}

}  // namespace lsos
