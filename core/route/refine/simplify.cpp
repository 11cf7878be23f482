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

}  // namespace lsos
