#include "route/refine/simplify.h"

#include <cmath>

namespace lsos {

Line2 corners(const Line2& line) {
  constexpr double straight_m = 1e-3;
  Line2 kept{line.front()};
  for (std::size_t k = 1; k + 1 < line.size(); ++k) {
    const Vec2 in = line[k] - kept.back(), out = line[k + 1] - line[k];
    const double aside_m = std::abs(in.x() * out.y() - in.y() * out.x());
    if (aside_m > straight_m * out.norm() || in.dot(out) < 0) kept.push_back(line[k]);
  }
  kept.push_back(line.back());
  return kept;
}

GearedLine corners(const Stretches& stretches) {
  GearedLine whole;
  bool is_backward = false;
  for (const Stretch& stretch : stretches) {
    const Line2 line = corners(stretch.line);
    const std::size_t first = whole.line.empty() ? 0 : whole.line.size() - 1;
    if (stretch.is_backward != is_backward) whole.gear_changes.push_back(first);
    is_backward = stretch.is_backward;
    whole.line.insert(whole.line.end(), line.begin() + (whole.line.empty() ? 0 : 1), line.end());
  }
  return whole;
}

}  // namespace lsos
