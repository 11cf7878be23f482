#include "view/ground/map_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lsos {

namespace {

constexpr double rounding_px = 1e-5;  // rounding error of projections

double snapped_px(double px) {
  const double line = std::round(px);
  return std::abs(px - line) < rounding_px ? line : px;
}

}  // namespace

MapHeights::MapHeights(const MapGrid& grid, const Body& body)
    : map_(grid.map(body)),
      columns_(static_cast<std::size_t>(grid.columns)),
      rows_(static_cast<std::size_t>(grid.rows)),
      is_periodic_(map_.period_px() == grid.columns),
      heights_m_(columns_ * rows_, std::numeric_limits<float>::quiet_NaN()) {}

// Wraps a column into one revolution, on maps whose columns go around the body.
double MapHeights::in_period(double u) const {
  const double period = map_.period_px();
  return period > 0 ? u - period * std::floor((u + 1) / period) : u;
}

bool MapHeights::holds(const std::optional<GridCoordinates>& at) const {
  if (!at) return false;
  const double u = in_period(at->u);
  return u >= -1 && u <= static_cast<double>(columns_) && at->v >= -1 &&
         at->v <= static_cast<double>(rows_);
}

std::optional<double> MapHeights::height_m(const GridCoordinates& at) const {
  const double columns = static_cast<double>(columns_), rows = static_cast<double>(rows_);
  double u = in_period(at.u);
  if (is_periodic_ && u < 0) u += columns;
  const double last_u = is_periodic_ ? columns : columns - 1;
  if (!(u >= 0 && u <= last_u && at.v >= 0 && at.v <= rows - 1)) return {};
  const auto left = std::min(static_cast<std::size_t>(u), columns_ - 1);
  const auto above = std::min(static_cast<std::size_t>(at.v), rows_ - 1);
  const std::size_t right = left + 1 < columns_ ? left + 1 : (is_periodic_ ? 0 : left);
  const std::size_t below = std::min(above + 1, rows_ - 1);
  const double to_right = u - static_cast<double>(left);
  const double down = at.v - static_cast<double>(above);
  // A cell of weight 0 may be missing.
  const auto mixed = [](double share, double from, double to) {
    return share == 0 ? from : (1 - share) * from + share * to;
  };
  const auto between = [&](std::size_t row) -> double {
    const float* heights_m = &heights_m_[row * columns_];
    return mixed(to_right, heights_m[left], heights_m[right]);
  };
  const double height_m = mixed(down, between(above), between(below));
  return std::isnan(height_m) ? std::nullopt : std::optional(height_m);
}

std::optional<GridCoordinates> MapHeights::coordinates(const Geodetic& place) const {
  const auto at = map_.coordinates(place);
  return at ? std::optional(GridCoordinates{snapped_px(at->u), snapped_px(at->v)}) : std::nullopt;
}

std::optional<double> MapHeights::height_m(const Geodetic& place) const {
  const auto at = coordinates(place);
  return at ? height_m(*at) : std::nullopt;
}

}  // namespace lsos
