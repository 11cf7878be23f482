#include "base/polyline.h"

#include <cstddef>
#include <utility>

#include "base/segment.h"

namespace lsos {

std::vector<Vec2> simplified(const std::vector<Vec2>& line_m, double tolerance_m) {
  std::vector<Vec2> simple_m;
  for (const std::size_t k : points_of_simplified(line_m, tolerance_m)) {
    simple_m.push_back(line_m[k]);
  }
  return simple_m;
}

std::vector<std::size_t> points_of_simplified(const std::vector<Vec2>& line_m, double tolerance_m) {
  if (line_m.empty()) return {};
  std::vector<bool> is_kept(line_m.size(), false);
  is_kept.front() = is_kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> pieces{{0, line_m.size() - 1}};
  while (!pieces.empty()) {
    const auto [first, last] = pieces.back();
    pieces.pop_back();
    std::size_t farthest = first;
    double greatest_m = tolerance_m;
    for (std::size_t k = first + 1; k < last; ++k) {
      const double distance_m = point_distance_m(line_m[first], line_m[last], line_m[k]);
      if (distance_m <= greatest_m) continue;
      greatest_m = distance_m;
      farthest = k;
    }
    if (farthest == first) continue;
    is_kept[farthest] = true;
    pieces.push_back({first, farthest});
    pieces.push_back({farthest, last});
  }
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < line_m.size(); ++k) {
    if (is_kept[k]) kept.push_back(k);
  }
  return kept;
}

}  // namespace lsos
