#include "product/study/place_spread.h"

#include <algorithm>
#include <cmath>

namespace lsos {

// The sums are updated case by case (Welford 1962), so that metres among kilometres lose no digits.
void PlaceSpread::add(const Vec2& place_m) {
  ++cases_;
  const Vec2 before_m = place_m - mean_m_;
  mean_m_ += before_m / static_cast<double>(cases_);
  const Vec2 after_m = place_m - mean_m_;
  xx_m2_ += before_m.x() * after_m.x();
  xy_m2_ += before_m.x() * after_m.y();
  yy_m2_ += before_m.y() * after_m.y();
}

// The squared distance from the mean, in standard deviations, of a two-dimensional normal
// distribution exceeds q with probability exp(-q / 2).
std::optional<SpreadEllipse> PlaceSpread::ellipse(double share) const {
  constexpr std::size_t cases_min = 3;
  if (cases_ < cases_min) return {};
  const double freedom = static_cast<double>(cases_ - 1);
  const double xx = xx_m2_ / freedom, xy = xy_m2_ / freedom, yy = yy_m2_ / freedom;
  const double middle = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy);
  const double squared = -2 * std::log(1 - share);
  SpreadEllipse ellipse;
  ellipse.centre_m = mean_m_;
  ellipse.semi_major_m = std::sqrt(squared * (middle + radius));
  ellipse.semi_minor_m = std::sqrt(squared * std::max(0.0, middle - radius));
  ellipse.angle_rad = std::atan2(2 * xy, xx - yy) / 2;
  ellipse.cases = cases_;
  return ellipse;
}

}  // namespace lsos
