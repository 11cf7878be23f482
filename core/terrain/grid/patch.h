// Smooth maps from the site plane to grid coordinates: cubic polynomials fitted to exact ones.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "terrain/grid/site_plane.h"

namespace lsos {

// Grid coordinates: column and row, whole numbers at cell centres.
struct GridCoordinates {
  double u = 0;
  double v = 0;
};

// The same with their derivatives by the site plane's x and y, 1/m.
struct GridPoint {
  double u = 0;
  double v = 0;
  double u_by_x = 0;
  double u_by_y = 0;
  double v_by_x = 0;
  double v_by_y = 0;
};

// Exact, slow map to grid coordinates; nullopt where the projection knows no such place. Where the
// grid goes around the body, u is right up to a whole number of `period` columns; else that is 0.
struct ExactMap {
  std::function<std::optional<GridCoordinates>(const PlanePoint&)> at;
  double period = 0;
};

// A square of the site plane: x from column * size, y from row * size.
struct PatchKey {
  int level = 0;  // size = coarsest size / 2^level
  std::int64_t column = 0;
  std::int64_t row = 0;

  auto operator<=>(const PatchKey&) const = default;
};

class Patch {
 public:
  static constexpr double coarsest_size_m = 2048;
  static constexpr int finest_level = 12;  // 0.5 m
  // A fit is good when it meets the exact map within this at points it was not made from. The
  // tolerance bounds the steps between patches, and is far below what a height can show.
  static constexpr double tolerance_px = 1e-6;

  // Fits a polynomial to the map on that square.
  Patch(const PatchKey& key, const ExactMap& map);
  // The linear map u = x / spacing, v = y / spacing, everywhere.
  static Patch scaling(double spacing_m);

  static PatchKey key_of(const PlanePoint& at, int level);
  bool holds(const PlanePoint& at) const {
    return at.x_m >= x_low_m_ && at.x_m < x_high_m_ && at.y_m >= y_low_m_ && at.y_m < y_high_m_;
  }

  // Whether the polynomial meets the exact map within the tolerance at all check points.
  bool is_good() const { return residual_px_ <= tolerance_px; }
  // Largest distance between polynomial and exact map at the check points; infinite where the map
  // knows no such place.
  double residual_px() const { return residual_px_; }
  GridPoint at(const PlanePoint& at) const;

 private:
  static constexpr int terms = 10;
  Patch() { uv_.fill(Vec2::Zero()); }

  static constexpr double infinite = std::numeric_limits<double>::infinity();
  double x_low_m_ = -infinite;
  double x_high_m_ = infinite;
  double y_low_m_ = -infinite;
  double y_high_m_ = infinite;
  double x_centre_m_ = 0;
  double y_centre_m_ = 0;
  double per_half_size_ = 1;  // 1/m
  double residual_px_ = 0;
  std::array<Vec2, terms> uv_;  // coefficients of u and v, evaluated side by side
};

// Grid point by differences of the exact map, for places where no polynomial is good enough.
std::optional<GridPoint> exact_grid_point(const ExactMap& map, const PlanePoint& at);

}  // namespace lsos
