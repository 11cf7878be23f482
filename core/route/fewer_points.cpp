#include "route/fewer_points.h"

#include <algorithm>
#include <limits>

namespace lsos {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// More points than these are thinned out first: the work grows with their cube.
constexpr std::size_t points_max = 100;
// Points are put between those of the line this far apart, at least.
constexpr double between_spacings = 6;

Line2 with_points_between(const Line2& line, double apart_m) {
  Line2 dense{line.front()};
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec2 way_m = line[k + 1] - line[k];
    const int pieces = std::max(1, static_cast<int>(way_m.norm() / apart_m));
    for (int piece = 1; piece <= pieces; ++piece) {
      dense.push_back(line[k] + way_m * (static_cast<double>(piece) / pieces));
    }
  }
  return dense;
}

}  // namespace

Line2 with_fewer_points(LegCosts& costs, const Line2& line) {
  double apart_m = between_spacings * costs.map().spacing_m();
  Line2 points = with_points_between(line, apart_m);
  for (; points.size() > points_max && apart_m < 1e6; apart_m *= 1.5) {
    points = with_points_between(line, apart_m);
  }
  const std::size_t count = points.size();
  if (count > 3 * points_max) return line;
  // best[to][from]: cost of the cheapest line to `to` whose last piece begins at `from`.
  std::vector<std::vector<double>> best(count, std::vector<double>(count, infinite));
  std::vector<std::vector<std::size_t>> before(count, std::vector<std::size_t>(count, 0));
  for (std::size_t to = 1; to < count; ++to) {
    for (std::size_t from = 0; from < to; ++from) {
      const double piece = costs.straight(points[from], points[to]);
      if (piece == infinite) continue;
      if (from == 0) best[to][0] = piece;
      for (std::size_t first = 0; first < from; ++first) {
        if (best[from][first] + piece >= best[to][from]) continue;
        const double cost =
            best[from][first] + piece + costs.corner(points[first], points[from], points[to]);
        if (cost >= best[to][from]) continue;
        best[to][from] = cost;
        before[to][from] = first;
      }
    }
  }
  std::size_t to = count - 1;
  auto from = static_cast<std::size_t>(std::ranges::min_element(best[to]) - best[to].begin());
  Line2 fewer{points[to]};
  while (to > 0) {
    fewer.push_back(points[from]);
    const std::size_t first = before[to][from];
    to = from;
    from = first;
  }
  std::ranges::reverse(fewer);
  return costs.along(fewer) < costs.along(line) ? fewer : line;
}

}  // namespace lsos
