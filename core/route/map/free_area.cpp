#include "route/map/free_area.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>

namespace lsos {

namespace {

constexpr double touch_m = 1e-3;     // a point this near to a side lies on it
constexpr double rounding_m = 1e-6;  // tolerance of a margin that is kept exactly
// Least margin: a path along a side itself could not be told from one inside the hole.
constexpr double margin_least_m = 0.01;
constexpr int margins_count = 5;   // the margin, a half, ... a sixteenth
constexpr double tests_max = 1e8;  // of sides against lines; more take some seconds
constexpr std::size_t corners_few = 1000;
constexpr double tests_per_line = 20;  // cost of queueing a line, in such tests

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

// Whether the place is within `radius_m` of a side.
bool is_within(const Ring& ring, const Vec2& p_m, double radius_m) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &c = ring[i], &d = after(ring, i);
    const bool is_far = std::max(c.x(), d.x()) < p_m.x() - radius_m ||
                        std::min(c.x(), d.x()) > p_m.x() + radius_m ||
                        std::max(c.y(), d.y()) < p_m.y() - radius_m ||
                        std::min(c.y(), d.y()) > p_m.y() + radius_m;
    if (!is_far && (nearest_on_segment(c, d, p_m) - p_m).norm() <= radius_m) return true;
  }
  return false;
}

// Shares of the line from a to b at which it crosses the ring, ascending, with 0 and 1.
std::vector<double> crossings(const Ring& ring, const Vec2& a_m, const Vec2& b_m) {
  std::vector<double> shares{0, 1};
  const Vec2 along_m = b_m - a_m;
  double left = cross(along_m, ring.front() - a_m);  // > 0 left of the line; few sides cross it
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &c = ring[i], &d = after(ring, i);
    const double left_c = left;
    left = cross(along_m, d - a_m);
    if (left_c * left > 0 || left_c == left) continue;
    const double t = cross(c - a_m, d - c) / (left - left_c);
    if (t > 0 && t < 1) shares.push_back(t);
  }
  std::ranges::sort(shares);
  return shares;
}

// Whether the test holds all along the line. Between two crossings the line lies either inside or
// outside the ring; three places of each part are tested.
template <typename Test>
bool holds_along(const Ring& ring, const Vec2& a_m, const Vec2& b_m, const Test& test) {
  const std::vector<double> shares = crossings(ring, a_m, b_m);
  for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
    for (const double share : {0.25, 0.5, 0.75}) {
      const double at = shares[i] + share * (shares[i + 1] - shares[i]);
      if (!test(a_m + at * (b_m - a_m))) return false;
    }
  }
  return true;
}

// Distance of a place from the hole, m; 0 inside it.
double away_m(const Ring& hole, const Vec2& p_m) {
  return contains(hole, p_m) ? 0 : (nearest_on_ring(hole, p_m) - p_m).norm();
}

// Ranges of t in which the line a + t (b - a) lies within the ring, from the sides that it crosses.
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

// Range of the line that is nearer than the radius to a side: its part in a strip with rounded
// ends, which is convex.
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
  // The discs around the ends of the side.
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

using Box = Eigen::AlignedBox2d;

Box box_of(const Vec2& a_m, const Vec2& b_m) { return Box(a_m).extend(b_m); }

// Whether the line stays outside the hole and `margin_m` away from it. A line that begins at the
// very edge may lie inside by rounding.
bool is_off(const Ring& hole, const Vec2& a_m, const Vec2& b_m, double margin_m) {
  if (margin_m <= rounding_m) {
    return holds_along(hole, a_m, b_m, [&](const Vec2& p_m) {
      return !contains(hole, p_m) || is_within(hole, p_m, rounding_m);
    });
  }
  const Vec2 reach_m(margin_m, margin_m);
  const Box line = box_of(a_m, b_m), near(line.min() - reach_m, line.max() + reach_m);
  for (std::size_t i = 0; i < hole.size(); ++i) {
    const Vec2 &c = hole[i], &d = after(hole, i);
    if (!near.intersects(box_of(c, d))) continue;
    if (segment_distance_m(c, d, a_m, b_m) < margin_m - rounding_m) return false;
  }
  return !contains(hole, (a_m + b_m) / 2);
}

}  // namespace

FreeArea::FreeArea(Ring outline, std::vector<Ring> holes)
    : outline_(turned_to(std::move(outline), true)), holes_(std::move(holes)) {
  for (Ring& hole : holes_) {
    hole = turned_to(std::move(hole), false);
    Box& box = boxes_.emplace_back();
    for (const Vec2& corner_m : hole) box.extend(corner_m);
  }
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

FreeArea::Limits FreeArea::limits(const Vec2& from_m, const Vec2& to_m, double margin_m) const {
  Limits limits;
  limits.margin_m = margin_m;
  const double out_m = std::max(outside_m(from_m), outside_m(to_m));
  limits.slack_m = out_m + touch_m;
  limits.are_full = out_m <= rounding_m;
  for (const Ring& hole : holes_) {
    const double ends_m = std::min(away_m(hole, from_m), away_m(hole, to_m));
    limits.margins_m.push_back(std::min(margin_m, ends_m));
    limits.are_full = limits.are_full && ends_m >= margin_m - rounding_m;
  }
  return limits;
}

double FreeArea::outside_m(const Vec2& p_m) const {
  return contains(outline_, p_m) ? 0 : (nearest_on_ring(outline_, p_m) - p_m).norm();
}

bool FreeArea::is_inside(const Vec2& p_m, double slack_m) const {
  return contains(outline_, p_m) || is_within(outline_, p_m, slack_m);
}

bool FreeArea::is_free(const Vec2& a_m, const Vec2& b_m, const Limits& limits) const {
  const Box line = box_of(a_m, b_m);
  for (std::size_t i = 0; i < holes_.size(); ++i) {
    const double margin_m = limits.margins_m[i];
    if (line.exteriorDistance(boxes_[i]) > margin_m) continue;
    if (!is_off(holes_[i], a_m, b_m, margin_m)) return false;
  }
  return holds_along(outline_, a_m, b_m,
                     [&](const Vec2& p_m) { return is_inside(p_m, limits.slack_m); });
}

bool FreeArea::can_turn_at(const Vec2& p_m, const Limits& limits) const {
  for (std::size_t i = 0; i < holes_.size(); ++i) {
    const double wanted_m = limits.margins_m[i] - rounding_m;
    if (boxes_[i].exteriorDistance(p_m) < wanted_m && away_m(holes_[i], p_m) < wanted_m) {
      return false;
    }
  }
  return is_inside(p_m, touch_m);
}

// Nearest place `margin_m` outside the hole that contains the point; absent where none does.
std::optional<Vec2> FreeArea::exit(const Vec2& p_m, double margin_m) const {
  for (const Ring& hole : holes_) {
    if (!contains(hole, p_m)) continue;
    const Vec2 edge_m = nearest_on_ring(hole, p_m), out_m = edge_m - p_m;
    if (out_m.norm() <= 0) continue;
    return edge_m + margin_m * out_m.normalized();
  }
  return {};
}

// Whether a line in this direction, or the opposite one, passes the obstacle at a turn without
// entering it.
bool FreeArea::is_tangent(const Turn& turn, const Vec2& delta_m) {
  const double slack_m = 1e-9 * delta_m.norm();
  const double in_m = cross(delta_m, turn.in), out_m = cross(delta_m, turn.out);
  return (in_m >= -slack_m && out_m <= slack_m) || (in_m <= slack_m && out_m >= -slack_m);
}

// Places where a path may turn: around each corner that protrudes into the free ground, outside the
// circle of the margin, with at most a right angle at each.
std::vector<FreeArea::Turn> FreeArea::corners(const Limits& limits) const {
  std::vector<Turn> turns;
  const auto add_ring = [&](const Ring& ring, double off_m) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &corner = ring[i], &before = ring[(i + ring.size() - 1) % ring.size()];
      const Vec2 in = corner - before, out = after(ring, i) - corner;
      if (in.norm() == 0 || out.norm() == 0) continue;
      // Free ground lies to the left of a side, so the ring turns right at a protruding corner.
      const double turn_rad = -bend_rad(in, out);
      if (turn_rad <= 0) continue;
      const int count =
          std::max(1, static_cast<int>(std::ceil(turn_rad / (std::numbers::pi / 2) - 1e-9)));
      const double step_rad = turn_rad / count;
      const Vec2 normal = Vec2(-in.y(), in.x()).normalized();
      for (int k = 0; k < count; ++k) {
        const double angle_rad = (k + 0.5) * step_rad;
        const Vec2 direction = Eigen::Rotation2Dd(-angle_rad) * normal;
        const Vec2 at_m = corner + off_m / std::cos(step_rad / 2) * direction;
        turns.push_back({at_m, Eigen::Rotation2Dd(-k * step_rad) * in.normalized(),
                         Eigen::Rotation2Dd(-(k + 1) * step_rad) * in.normalized()});
      }
    }
  };
  add_ring(outline_, limits.outline_margin_m);
  for (const Ring& hole : holes_) add_ring(hole, limits.margin_m);
  return turns;
}

// Lazy A*: the straight distance to the end is a lower bound of the path to it. A line is tested
// when it comes first in the queue, which most never do.
std::optional<FreeArea::Path> FreeArea::search(const Vec2& from_m, const Vec2& to_m,
                                               const Limits& limits) const {
  if (is_free(from_m, to_m, limits)) return Path{{to_m}, limits.margin_m};
  struct Line {
    double total_m;  // lower bound of the path through it
    std::uint32_t from, to;
    bool operator>(const Line& other) const { return total_m > other.total_m; }
  };
  std::vector<Turn> places{{from_m, {0, 0}, {0, 0}}, {to_m, {0, 0}, {0, 0}}};
  for (const Turn& place : corners(limits)) places.push_back(place);
  enum class State { unknown, open, done };
  std::vector<State> states(places.size(), State::unknown);
  std::vector<double> cost_m(places.size(), 0);
  std::vector<std::size_t> previous(places.size(), 0);
  std::priority_queue<Line, std::vector<Line>, std::greater<>> lines;
  // A shortest path is tangent to what it turns at. It may also cut between a circle and the turns
  // outside it; such lines are tried where the corners are few.
  const bool tangents_only = limits.are_full && size() > corners_few;
  const auto can_be_shortest = [&](std::size_t from, std::size_t to, const Vec2& delta_m) {
    if (!tangents_only || from < 2 || to < 2) return true;
    return is_tangent(places[from], delta_m) && is_tangent(places[to], delta_m);
  };
  double tests = 0;
  const auto reach = [&](std::uint32_t at) {
    states[at] = State::done;
    tests += static_cast<double>(places.size());
    for (std::uint32_t i = 1; i < places.size(); ++i) {
      if (states[i] == State::done) continue;
      const Vec2 delta_m = places[i].at_m - places[at].at_m;
      if (!can_be_shortest(at, i, delta_m)) continue;
      tests += tests_per_line;
      lines.push({cost_m[at] + delta_m.norm() + (to_m - places[i].at_m).norm(), at, i});
    }
  };
  reach(0);
  while (states[1] != State::done) {
    if (lines.empty()) return {};
    const Line line = lines.top();
    lines.pop();
    if (states[line.to] == State::done) continue;
    tests += static_cast<double>(size());
    if (tests > tests_max) return Path{{}, 0, true};
    if (states[line.to] == State::unknown) {
      const bool is_well = line.to == 1 || can_turn_at(places[line.to].at_m, limits);
      states[line.to] = is_well ? State::open : State::done;
      if (!is_well) continue;
    }
    const Vec2 &begin_m = places[line.from].at_m, &end_m = places[line.to].at_m;
    if (!is_free(begin_m, end_m, limits)) continue;
    cost_m[line.to] = cost_m[line.from] + (end_m - begin_m).norm();
    previous[line.to] = line.from;
    reach(line.to);
  }
  Path path{{}, limits.margin_m};
  for (std::size_t at = 1; at != 0; at = previous[at]) path.points_m.push_back(places[at].at_m);
  std::ranges::reverse(path.points_m);
  return path;
}

std::optional<FreeArea::Path> FreeArea::path(const Vec2& from_m, const Vec2& to_m,
                                             double margin_m) const {
  margin_m = std::max(margin_m, margin_least_m);
  Vec2 begin_m = from_m;
  const auto out_m = exit(from_m, margin_m);
  if (out_m) begin_m = *out_m;
  const int count = holes_.empty() ? 1 : margins_count;
  for (int i = 0; i < count; ++i, margin_m /= 2) {
    Limits limits = this->limits(begin_m, to_m, margin_m);
    // The margin applies to the outline's corners too where there is room, else the least margin.
    for (const double outline_margin_m : {margin_m, margin_least_m}) {
      limits.outline_margin_m = outline_margin_m;
      auto found = search(begin_m, to_m, limits);
      const bool is_last = outline_margin_m == margin_least_m;
      if (!found || (found->is_given_up && !is_last)) continue;
      if (out_m && !found->is_given_up) found->points_m.insert(found->points_m.begin(), *out_m);
      return found;
    }
  }
  return {};
}

}  // namespace lsos
