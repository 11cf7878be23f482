#include "base/polygon.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace lsos {

namespace {

bool do_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto sides_differ = [](double first, double second) {
    return (first > 0 && second < 0) || (first < 0 && second > 0);
  };
  return sides_differ(cross(b - a, c - a), cross(b - a, d - a)) &&
         sides_differ(cross(d - c, a - c), cross(d - c, b - c));
}

// Whether two sides share a point; bounding boxes rule out most pairs.
bool do_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto are_apart = [&](int axis) {
    return std::max(a[axis], b[axis]) < std::min(c[axis], d[axis]) ||
           std::max(c[axis], d[axis]) < std::min(a[axis], b[axis]);
  };
  return !are_apart(0) && !are_apart(1) && segment_distance_m(a, b, c, d) == 0;
}

// Whether the test holds for any two sides that are not neighbours. The sides are swept from west
// to east, each tested only against those that begin before it ends.
template <typename Test>
bool any_sides(const Ring& ring, const Test& test) {
  const auto west_m = [&](std::size_t i) { return std::min(ring[i].x(), after(ring, i).x()); };
  const auto east_m = [&](std::size_t i) { return std::max(ring[i].x(), after(ring, i).x()); };
  std::vector<std::size_t> order(ring.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, west_m);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t i = order[k];
    for (std::size_t l = k + 1; l < order.size() && west_m(order[l]) <= east_m(i); ++l) {
      const std::size_t j = order[l], between = i < j ? j - i : i - j;
      if (between <= 1 || between + 1 == ring.size()) continue;
      if (test(ring[i], after(ring, i), ring[j], after(ring, j))) return true;
    }
  }
  return false;
}

}  // namespace

bool contains(const Ring& ring, const Vec2& p_m) {
  bool is_inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = after(ring, i);
    if ((a.y() <= p_m.y()) == (b.y() <= p_m.y())) continue;
    const double x_m = a.x() + (b.x() - a.x()) * (p_m.y() - a.y()) / (b.y() - a.y());
    if (x_m > p_m.x()) is_inside = !is_inside;
  }
  return is_inside;
}

Vec2 nearest_on_segment(const Vec2& a_m, const Vec2& b_m, const Vec2& p_m) {
  return a_m + nearest_share(a_m, b_m, p_m) * (b_m - a_m);
}

Vec2 nearest_on_ring(const Ring& ring, const Vec2& p_m) {
  Vec2 nearest_m = ring.front();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 on_side_m = nearest_on_segment(ring[i], after(ring, i), p_m);
    if ((on_side_m - p_m).squaredNorm() < (nearest_m - p_m).squaredNorm()) nearest_m = on_side_m;
  }
  return nearest_m;
}

double segment_distance_m(const Vec2& a_m, const Vec2& b_m, const Vec2& c_m, const Vec2& d_m) {
  if (do_cross(a_m, b_m, c_m, d_m)) return 0;
  return std::min(std::min((nearest_on_segment(c_m, d_m, a_m) - a_m).norm(),
                           (nearest_on_segment(c_m, d_m, b_m) - b_m).norm()),
                  std::min((nearest_on_segment(a_m, b_m, c_m) - c_m).norm(),
                           (nearest_on_segment(a_m, b_m, d_m) - d_m).norm()));
}

double ring_distance_m(const Ring& ring, const Vec2& a_m, const Vec2& b_m) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    least_m = std::min(least_m, segment_distance_m(ring[i], after(ring, i), a_m, b_m));
  }
  return least_m;
}

bool do_touch(const Ring& a, const Ring& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (do_meet(a[i], after(a, i), b[k], after(b, k))) return true;
    }
  }
  return false;
}

bool crosses_itself(const Ring& ring) { return any_sides(ring, do_cross); }

bool touches_itself(const Ring& ring) { return any_sides(ring, do_meet); }

double doubled_area_m2(const Ring& ring) {
  double sum_m2 = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    sum_m2 += cross(ring[i] - ring.front(), after(ring, i) - ring.front());
  }
  return sum_m2;
}

}  // namespace lsos
