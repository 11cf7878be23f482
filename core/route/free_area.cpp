#include "route/free_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lsos {

namespace {

constexpr double touch_m = 1e-3;         // what is this near to a side lies on it
constexpr double rounding_m = 1e-6;      // of a margin that is kept exactly
constexpr double margin_least_m = 0.01;  // a path along a side itself could not be told from one in
constexpr int margins_count = 5;         // the margin, a half, ... a sixteenth
constexpr double tests_max = 5e7;        // of sides against lines; more takes over a second

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

const Vec2& after(const Ring& ring, std::size_t i) { return ring[(i + 1) % ring.size()]; }

Ring turned_to(Ring ring, bool is_counter_clockwise) {
  if ((doubled_area_m2(ring) > 0) != is_counter_clockwise) std::ranges::reverse(ring);
  return ring;
}

using Shares = std::vector<std::pair<double, double>>;

void sort_and_join(Shares& shares) {
  std::ranges::sort(shares);
  Shares joined;
  for (const auto& [from, to] : shares) {
    if (!joined.empty() && from <= joined.back().second) {
      joined.back().second = std::max(joined.back().second, to);
    } else {
      joined.emplace_back(from, to);
    }
  }
  shares = std::move(joined);
}

// How far from the hole a place is, m; 0 inside it.
double apath_m(const Ring& hole, const Vec2& p_m) {
  return contains(hole, p_m) ? 0 : (nearest_on_ring(hole, p_m) - p_m).norm();
}

// Where the line a + t (b - a) lies within the ring, by the sides that it crosses.
Shares shares_inside(const Ring& ring, const Vec2& a_m, const Vec2& b_m) {
  const Vec2 along_m = b_m - a_m;
  std::vector<double> crossings;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &c = ring[i], &d = after(ring, i);
    const double side_c = cross(along_m, c - a_m), side_d = cross(along_m, d - a_m);
    if ((side_c <= 0) == (side_d <= 0)) continue;
    const Vec2 at_m = c + (d - c) * (side_c / (side_c - side_d));
    crossings.push_back((at_m - a_m).dot(along_m) / along_m.squaredNorm());
  }
  std::ranges::sort(crossings);
  Shares shares;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    shares.emplace_back(crossings[i], crossings[i + 1]);
  }
  return shares;
}

// Where the line comes nearer than the radius to a side: a round-ended strip, which is convex.
std::optional<std::pair<double, double>> share_near(const Vec2& a_m, const Vec2& b_m,
                                                    const Vec2& c_m, const Vec2& d_m,
                                                    double radius_m) {
  const double length_m = (b_m - a_m).norm();
  const Vec2 along = (b_m - a_m) / length_m, up(-along.y(), along.x());
  double least_m = std::numeric_limits<double>::infinity(), most_m = -least_m;
  const auto reach = [&](double from_m, double to_m) {
    least_m = std::min(least_m, from_m);
    most_m = std::max(most_m, to_m);
  };
  // The discs about its ends.
  for (const Vec2& end_m : {c_m, d_m}) {
    const double off_m = up.dot(end_m - a_m), at_m = along.dot(end_m - a_m);
    if (std::abs(off_m) >= radius_m) continue;
    const double half_m = std::sqrt(radius_m * radius_m - off_m * off_m);
    reach(at_m - half_m, at_m + half_m);
  }
  // The straight sides of the strip.
  const Vec2 side_m = d_m - c_m;
  if (side_m.norm() > 0) {
    const Vec2 normal(-side_m.y() / side_m.norm(), side_m.x() / side_m.norm());
    for (const double sign : {-1.0, 1.0}) {
      const Vec2 p_m = c_m + sign * radius_m * normal, q_m = d_m + sign * radius_m * normal;
      const double off_p = up.dot(p_m - a_m), off_q = up.dot(q_m - a_m);
      if ((off_p <= 0) == (off_q <= 0)) continue;
      const double at_m = along.dot(p_m + (q_m - p_m) * (off_p / (off_p - off_q)) - a_m);
      reach(at_m, at_m);
    }
  }
  if (least_m > most_m) return {};
  return std::pair(least_m / length_m, most_m / length_m);
}

}  // namespace

FreeArea::FreeArea(Ring outline, std::vector<Ring> holes)
    : outline_(turned_to(std::move(outline), true)), holes_(std::move(holes)) {
  for (Ring& hole : holes_) hole = turned_to(std::move(hole), false);
}

std::size_t FreeArea::size() const {
  std::size_t count = outline_.size();
  for (const Ring& hole : holes_) count += hole.size();
  return count;
}

std::vector<std::pair<double, double>> FreeArea::parts(const Vec2& from_m, const Vec2& to_m,
                                                       double margin_m) const {
  Shares blocked;
  for (const Ring& hole : holes_) {
    for (const auto& share : shares_inside(hole, from_m, to_m)) blocked.push_back(share);
    for (std::size_t i = 0; i < hole.size(); ++i) {
      const auto near = share_near(from_m, to_m, hole[i], after(hole, i), margin_m);
      if (near) blocked.push_back(*near);
    }
  }
  sort_and_join(blocked);
  Shares free;
  for (const auto& [begin, end] : shares_inside(outline_, from_m, to_m)) {
    double at = std::max(begin, 0.0);
    const double last = std::min(end, 1.0);
    for (const auto& [from, to] : blocked) {
      if (from > at && from < last) free.emplace_back(at, from);
      at = std::max(at, std::min(to, last));
    }
    if (at < last) free.emplace_back(at, last);
  }
  return free;
}

// From the holes, m; 0 inside one.
double FreeArea::clearance_m(const Vec2& p_m) const {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Ring& hole : holes_) least_m = std::min(least_m, apath_m(hole, p_m));
  return least_m;
}

FreeArea::Limits FreeArea::limits(const Vec2& from_m, const Vec2& to_m, double margin_m) const {
  Limits limits;
  limits.slack_m = std::max(outside_m(from_m), outside_m(to_m)) + touch_m;
  for (const Ring& hole : holes_) {
    const double ends_m = std::min(apath_m(hole, from_m), apath_m(hole, to_m));
    limits.margins_m.push_back(std::max(2 * rounding_m, std::min(margin_m, ends_m)));
  }
  return limits;
}

double FreeArea::outside_m(const Vec2& p_m) const {
  return contains(outline_, p_m) ? 0 : (nearest_on_ring(outline_, p_m) - p_m).norm();
}

bool FreeArea::is_inside(const Vec2& p_m, double slack_m) const {
  return contains(outline_, p_m) || (nearest_on_ring(outline_, p_m) - p_m).norm() <= slack_m;
}

bool FreeArea::is_free(const Vec2& a_m, const Vec2& b_m, const Limits& limits) const {
  for (std::size_t i = 0; i < holes_.size(); ++i) {
    if (ring_distance_m(holes_[i], a_m, b_m) < limits.margins_m[i] - rounding_m) return false;
    if (contains(holes_[i], (a_m + b_m) / 2)) return false;
  }
  // Between two crossings of the outline a line is inside it, or outside.
  std::vector<double> crossings{0, 1};
  const Vec2 along_m = b_m - a_m;
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const Vec2 &c = outline_[i], side_m = after(outline_, i) - c;
    const double across = cross(along_m, side_m);
    if (across == 0) continue;
    const double t = cross(c - a_m, side_m) / across, u = cross(c - a_m, along_m) / across;
    if (t > 0 && t < 1 && u >= 0 && u <= 1) crossings.push_back(t);
  }
  std::ranges::sort(crossings);
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const double from = crossings[i], step = crossings[i + 1] - from;
    for (const double share : {0.25, 0.5, 0.75}) {
      if (!is_inside(a_m + (from + share * step) * along_m, limits.slack_m)) return false;
    }
  }
  return true;
}

// The nearest place outside the hole that the point lies in; absent where it lies in none.
std::optional<Vec2> FreeArea::exit(const Vec2& p_m, double margin_m) const {
  for (const Ring& hole : holes_) {
    if (!contains(hole, p_m)) continue;
    const Vec2 edge_m = nearest_on_ring(hole, p_m), out_m = edge_m - p_m;
    if (out_m.norm() <= 0) continue;
    return edge_m + margin_m * out_m.normalized();
  }
  return {};
}

// Places to turn at: round each corner that sticks out into the free ground, outside a circle of
// the margin, at most a right angle at each.
std::vector<Vec2> FreeArea::corners(double margin_m) const {
  std::vector<Vec2> places;
  const auto add_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &corner = ring[i], &before = ring[(i + ring.size() - 1) % ring.size()];
      const Vec2 in = corner - before, out = after(ring, i) - corner;
      if (in.norm() == 0 || out.norm() == 0) continue;
      // Free ground lies to the left of a side: the line turns right at what sticks out.
      const double turn_rad = -std::atan2(cross(in, out), in.dot(out));
      if (turn_rad <= 0) continue;
      const int count =
          std::max(1, static_cast<int>(std::ceil(turn_rad / (std::numbers::pi / 2) - 1e-9)));
      const double step_rad = turn_rad / count;
      const Vec2 normal = Vec2(-in.y(), in.x()).normalized();
      for (int k = 0; k < count; ++k) {
        const double angle_rad = (k + 0.5) * step_rad;
        const Vec2 direction = Eigen::Rotation2Dd(-angle_rad) * normal;
        const Vec2 place_m = corner + margin_m / std::cos(step_rad / 2) * direction;
        if (is_inside(place_m, touch_m) && clearance_m(place_m) >= margin_m - rounding_m) {
          places.push_back(place_m);
        }
      }
    }
  };
  add_ring(outline_);
  for (const Ring& hole : holes_) add_ring(hole);
  return places;
}

std::optional<std::vector<Vec2>> FreeArea::search(const Vec2& from_m, const Vec2& to_m,
                                                  double margin_m, const Limits& limits) const {
  std::vector<Vec2> places{from_m, to_m};
  for (const Vec2& place : corners(margin_m)) places.push_back(place);
  constexpr double far_m = std::numeric_limits<double>::infinity();
  std::vector<double> cost_m(places.size(), far_m);
  std::vector<std::size_t> previous(places.size(), 0);
  std::vector<bool> is_done(places.size(), false);
  cost_m[0] = 0;
  double tests = 0;
  // A*: the straight distance to the end is a lower bound of the path to it.
  for (;;) {
    std::size_t best = places.size();
    double best_m = far_m;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double total_m = cost_m[i] + (places[i] - to_m).norm();
      if (!is_done[i] && total_m < best_m) {
        best = i;
        best_m = total_m;
      }
    }
    if (best == places.size()) return {};
    if (best == 1) break;
    is_done[best] = true;
    for (std::size_t i = 1; i < places.size(); ++i) {
      const double path_m = cost_m[best] + (places[i] - places[best]).norm();
      if (is_done[i] || path_m >= cost_m[i]) continue;
      tests += static_cast<double>(size());
      if (tests > tests_max) return {};
      if (!is_free(places[best], places[i], limits)) continue;
      cost_m[i] = path_m;
      previous[i] = best;
    }
  }
  std::vector<Vec2> points_m;
  for (std::size_t at = 1; at != 0; at = previous[at]) points_m.push_back(places[at]);
  std::ranges::reverse(points_m);
  return points_m;
}

std::optional<FreeArea::Path> FreeArea::path(const Vec2& from_m, const Vec2& to_m,
                                             double margin_m) const {
  margin_m = std::max(margin_m, margin_least_m);
  Path path;
  Vec2 begin_m = from_m;
  if (const auto out_m = exit(from_m, margin_m)) {
    path.points_m.push_back(*out_m);
    begin_m = *out_m;
  }
  for (int i = 0; i < margins_count; ++i, margin_m /= 2) {
    const auto found = search(begin_m, to_m, margin_m, limits(begin_m, to_m, margin_m));
    if (!found) continue;
    path.points_m.insert(path.points_m.end(), found->begin(), found->end());
    path.margin_m = margin_m;
    return path;
  }
  return {};
}

}  // namespace lsos
