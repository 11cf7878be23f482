#include "route/fewer_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace lsos {

namespace {

double off_m(const Vec2& at_m, const Vec2& from_m, const Vec2& to_m) {
  const Vec2 way_m = to_m - from_m;
  const double squared = way_m.squaredNorm();
  const double share = squared > 0 ? std::clamp((at_m - from_m).dot(way_m) / squared, 0.0, 1.0) : 0;
  return (at_m - from_m - share * way_m).norm();
}

}  // namespace

Line2 with_fewer_points(const Line2& line, double off_max_m) {
  if (line.size() < 3) return line;
  std::vector<bool> is_kept(line.size(), false);
  is_kept.front() = is_kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> pieces{{0, line.size() - 1}};
  while (!pieces.empty()) {
    const auto [first, last] = pieces.back();
    pieces.pop_back();
    std::size_t farthest = first;
    double most_m = off_max_m;
    for (std::size_t k = first + 1; k < last; ++k) {
      const double now_m = off_m(line[k], line[first], line[last]);
      if (now_m <= most_m) continue;
      most_m = now_m;
      farthest = k;
    }
    if (farthest == first) continue;
    is_kept[farthest] = true;
    pieces.push_back({first, farthest});
    pieces.push_back({farthest, last});
  }
  Line2 fewer;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (is_kept[k]) fewer.push_back(line[k]);
  }
  return fewer;
}

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
