// How far places of many cases lie from each other: an ellipse that holds a share of them, as of a
// two-dimensional normal distribution with their mean and covariance.
#pragma once

#include <cstddef>
#include <optional>

#include "base/vector.h"

namespace lsos {

// In a plane with x east and y north.
struct SpreadEllipse {
  Vec2 centre_m{0, 0};
  double semi_major_m = 0, semi_minor_m = 0;
  double angle_rad = 0;  // of the major axis, anticlockwise from east, -pi/2..pi/2
  std::size_t cases = 0;
};

// Share of cases that ellipses on pages and maps are to hold.
inline constexpr double spread_share = 0.9;

class PlaceSpread {
 public:
  void add(const Vec2& place_m);
  std::size_t cases() const { return cases_; }
  // Absent of fewer than three cases. `share`: in (0, 1).
  std::optional<SpreadEllipse> ellipse(double share = spread_share) const;

 private:
  std::size_t cases_ = 0;
  Vec2 mean_m_{0, 0};
  // Sums of products of differences from the mean.
  double xx_m2_ = 0, xy_m2_ = 0, yy_m2_ = 0;
};

}  // namespace lsos
