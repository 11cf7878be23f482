#include "route/search/turning_search.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <queue>
#include <span>
#include <unordered_set>

#include "route/search/cost_to_go.h"
#include "route/search/grid_search.h"

namespace lsos {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Curvatures of the edges, in tightest turns; the straight one first. A fast rover slows down much
// for the sharp ones, and hardly for the last.
constexpr double turns[] = {0, 1, -1, 0.5, -0.5, 0.25, -0.25, 0.125, -0.125};
// From this one on it is slow.
constexpr double slow_turn = 0.5;
// The way to the goal is closed from poses that are nearer to it than so many radii.
constexpr double closing_radii = 4;
// What is left to the goal counts so much more than it must: far fewer poses are looked at for a
// route that is no more than about this share costlier. Refining makes up for it. Where so many
// poses do not lead to the goal they are looked at anew, in more haste.
struct Pace {
  double haste;
  std::size_t poses;
};
constexpr Pace fine_paces[] = {{1.04, 60'000}, {1.1, 40'000}, {1.2, 60'000}, {1.4, 360'000}};
// Coarsely there are an eighth of the poses; less haste leads nowhere over rough ground, and
// refining makes the ways as good.
constexpr Pace coarse_paces[] = {{1.2, 15'000}, {1.5, 15'000}, {2, 60'000}};

// How closely poses are looked at: each stands for all that lie in its cell.
struct Grain {
  int spacings;  // of a cell in each direction, and of the lattice that tells what is left
  int headings;
  std::span<const Pace> paces;
};
constexpr Grain fine{1, 36, fine_paces}, coarse{2, 18, coarse_paces};

// Ways that cost so much more over the lattice than the cheapest are not looked at, with room for
// so many full turns: where the rover does not come on, all ground would be. Where nothing else is
// left, longer ones are.
constexpr double detours[] = {1.5, 4}, loops = 1.5;

struct Reached {
  Pose2 pose;
  double cost = 0;
  std::int32_t before = -1;
  double curvature_1pm = 0;  // of the edge to it
  LegCosts::Speeds speeds;
};

// A pose; or what an edge from it leads to, whose cost is a bound until it is looked at; or all of
// a way, closed from it.
struct Candidate {
  enum class Kind : std::uint8_t { pose, edge, closing };
  double total = 0;
  double cost = 0;
  std::int32_t node = 0;
  Kind kind = Kind::pose;
  double turn = 0;  // of an edge or a closing arc, in tightest turns

  // std::priority_queue takes the greatest: the least total, then the farthest come.
  bool operator<(const Candidate& other) const {
    if (total != other.total) return total > other.total;
    if (cost != other.cost) return cost < other.cost;
    if (node != other.node) return node > other.node;
    return turn > other.turn;
  }
};

class Search {
 public:
  Search(LegCosts& costs, const Pose2& start, const Vec2& goal_m, double radius_m,
         const TurningGuide& guide)
      : costs_(costs),
        map_(costs.map()),
        start_(start),
        goal_m_(goal_m),
        grain_(guide.is_coarse ? coarse : fine),
        coarser_(guide.is_coarse ? std::make_unique<Coarser>(costs) : nullptr),
        to_go_(coarser_ ? coarser_->costs : costs, start.at_m, goal_m, guide.within),
        radius_m_(radius_m),
        cell_m_(grain_.spacings * map_.spacing_m()),
        step_m_(std::max(2 * std::numbers::pi / grain_.headings * radius_m, 1.5 * cell_m_)) {}

  TurningRoute run(std::size_t poses_max) {
    TurningRoute route;
    route.nearest_m = start_.at_m;
    route.cost = infinite;
    // There are too many poses to look at them all for nothing.
    const double least = to_go_.at(start_.at_m);
    if (!std::isfinite(least)) return route;
    const double far_m = std::max(step_m_, (goal_m_ - start_.at_m).norm());
    const double turning = loops * 2 * std::numbers::pi * radius_m_ *
                           std::max(least / far_m, costs_.steep_per_metre());
    std::size_t poses_left = poses_max;
    for (const double detour : detours) {
      to_go_.set_limit(detour * least + turning);
      if (!run_out(poses_left, route)) return route;
      if (!to_go_.was_limited()) break;
    }
    route.is_shut_in = !was_cut_;
    route.is_at_border = is_at_border_;
    return route;
  }

 private:
  // Whether all poses that can be reached were looked at, to no end. Takes those of `left`.
  bool run_out(std::size_t& left, TurningRoute& route) {
    for (const Pace& pace : grain_.paces) {
      begin(pace.haste);
      const bool is_found = come_to_goal(std::min(pace.poses, left), route);
      left -= std::min(left, closed_.size());
      if (is_found) return false;
      if (queue_.empty()) return true;
    }
    return false;
  }

  void begin(double haste) {
    haste_ = haste;
    least_ = infinite;
    is_at_border_ = was_cut_ = false;
    closed_.clear();
    reached_.clear();
    queue_ = {};
    reached_.push_back({start_, 0, -1, 0, {}});
    queue_.push({left(start_.at_m), 0, 0});
  }

  // Whether it does, by so many poses.
  bool come_to_goal(std::size_t poses, TurningRoute& route) {
    while (!queue_.empty() && closed_.size() < poses) {
      const Candidate best = queue_.top();
      queue_.pop();
      if (best.kind == Candidate::Kind::closing) {
        finish(best, route);
        return true;
      }
      if (best.kind == Candidate::Kind::edge) {
        look(best);
        continue;
      }
      const Reached& node = reached_[static_cast<std::size_t>(best.node)];
      const Pose2 pose = node.pose;
      if (!closed_.insert(cell_of(pose, node.curvature_1pm)).second) continue;
      const double off_m = (pose.at_m - goal_m_).norm();
      if (off_m < (route.nearest_m - goal_m_).norm()) route.nearest_m = pose.at_m;
      expand(best, pose);
      if (off_m < closing_radii * radius_m_) close(best, pose);
    }
    return false;
  }

  // Over open ground a line costs as much less than the way over the lattice as it is shorter.
  double left(const Vec2& at_m) {
    const Vec2 way_m = goal_m_ - at_m;
    const double straighter = way_m.norm() / std::max(1e-9, octile_m(way_m));
    return haste_ * straighter * to_go_.at(at_m);
  }

  // Gentle arcs are longer: each turns by as much as the gentlest of the slow ones.
  double edge_m(double curvature_1pm) const {
    const double turn = std::abs(curvature_1pm) * radius_m_;
    return turn == 0 || turn >= slow_turn ? step_m_ : step_m_ * slow_turn / turn;
  }
  // What a pose costs later depends on the arc that it is come to by: the rover slows down for
  // another one.
  std::size_t cell_of(const Pose2& pose, double curvature_1pm) const {
    const Vec2 cells = (pose.at_m - map_.low_m()) / cell_m_;
    const auto column = std::clamp(std::lround(cells.x()), 0L, map_.columns() - 1L);
    const auto row = std::clamp(std::lround(cells.y()), 0L, map_.rows() - 1L);
    const double turn = pose.yaw_rad / (2 * std::numbers::pi);
    const long heading = std::lround((turn - std::floor(turn)) * grain_.headings) % grain_.headings;
    const long kind = std::abs(curvature_1pm) * radius_m_ < slow_turn ? 0 : 1;
    return static_cast<std::size_t>(
        ((row * map_.columns() + column) * grain_.headings + heading) * 2 + kind);
  }

  // Edges come first by what they cost at least: most are never looked at.
  void expand(const Candidate& from, const Pose2& pose) {
    const double height_m = map_.height_m(pose.at_m);
    for (const double turn : turns) {
      const double curvature_1pm = turn / radius_m_, length_m = edge_m(curvature_1pm);
      const Pose2 to = along_arc(pose, curvature_1pm, length_m);
      is_at_border_ = is_at_border_ || costs_.is_at_border(to.at_m);
      const double rise_m = map_.height_m(to.at_m) - height_m;
      if (std::isnan(rise_m) || closed_.contains(cell_of(to, curvature_1pm))) continue;
      const double left = this->left(to.at_m);
      was_cut_ = was_cut_ || !std::isfinite(left);
      if (!std::isfinite(left)) continue;
      const double cost = from.cost + costs_.least((to.at_m - pose.at_m).norm(), rise_m) +
                          arc(from.node, turn).cost;
      queue_.push({cost + left, cost, from.node, Candidate::Kind::edge, turn});
    }
  }

  // Of slowing down for an edge, and the speeds after it.
  struct EdgeArc {
    double cost = 0;
    LegCosts::Speeds speeds;
  };
  EdgeArc arc(std::int32_t from, double turn) const {
    const Reached& node = reached_[static_cast<std::size_t>(from)];
    const double curvature_1pm = turn / radius_m_, length_m = edge_m(curvature_1pm);
    EdgeArc arc{0, node.speeds};
    if (turn == 0) {
      arc.speeds.free_m += length_m;
      return arc;
    }
    // From one side to the other the points of the line go straight on.
    if (turn * node.curvature_1pm < 0) {
      arc.speeds.free_m += length_m / arc_pieces(curvature_1pm, length_m, map_.spacing_m());
    }
    arc.cost =
        costs_.arc(arc.speeds, 1 / std::abs(curvature_1pm), length_m * std::abs(curvature_1pm));
    return arc;
  }

  void look(const Candidate& edge) {
    const Reached& from = reached_[static_cast<std::size_t>(edge.node)];
    const double curvature_1pm = edge.turn / radius_m_, length_m = edge_m(curvature_1pm);
    const Pose2 to = along_arc(from.pose, curvature_1pm, length_m);
    if (closed_.contains(cell_of(to, curvature_1pm))) return;
    const double along =
        costs_.along(arc_line(from.pose, curvature_1pm, length_m, map_.spacing_m()));
    if (!std::isfinite(along)) return;
    const EdgeArc arc = this->arc(edge.node, edge.turn);
    const double cost = from.cost + along + arc.cost;
    reached_.push_back({to, cost, edge.node, curvature_1pm, arc.speeds});
    queue_.push({cost + left(to.at_m), cost, static_cast<std::int32_t>(reached_.size() - 1)});
  }

  void close(const Candidate& from, const Pose2& pose) {
    const Vec2 way_m = goal_m_ - pose.at_m;
    const double rise_m = map_.height_m(goal_m_) - map_.height_m(pose.at_m);
    if (!(from.cost + costs_.least(way_m.norm(), rise_m) < least_)) return;
    for (const double share : turns) {
      if (share == 0) continue;
      const double radius_m = radius_m_ / std::abs(share);
      const auto line = arc_and_straight(pose, goal_m_, radius_m, share > 0, map_.spacing_m());
      if (!line) continue;
      double cost = from.cost + costs_.along(*line);
      double turn_m = 0;
      for (std::size_t k = 0; k + 2 < line->size(); ++k) {
        turn_m += ((*line)[k + 1] - (*line)[k]).norm();
      }
      LegCosts::Speeds speeds = reached_[static_cast<std::size_t>(from.node)].speeds;
      if (turn_m > 0) cost += costs_.arc(speeds, radius_m, turn_m / radius_m);
      if (!(cost < least_)) continue;
      least_ = cost;
      queue_.push({cost, cost, from.node, Candidate::Kind::closing, share});
    }
  }

  void finish(const Candidate& end, TurningRoute& route) const {
    std::vector<Reached> way;
    for (std::int32_t node = end.node; node >= 0;) {
      way.push_back(reached_[static_cast<std::size_t>(node)]);
      node = way.back().before;
    }
    std::ranges::reverse(way);
    route.line = {way.front().pose.at_m};
    for (std::size_t k = 0; k < way.size(); ++k) {
      route.poses.push_back(way[k].pose);
      if (k == 0) continue;
      const Line2 arc = arc_line(way[k - 1].pose, way[k].curvature_1pm,
                                 edge_m(way[k].curvature_1pm), map_.spacing_m());
      route.line.insert(route.line.end(), arc.begin() + 1, arc.end());
    }
    const auto last = arc_and_straight(way.back().pose, goal_m_, radius_m_ / std::abs(end.turn),
                                       end.turn > 0, map_.spacing_m());
    route.line.insert(route.line.end(), last->begin() + 1, last->end());
    const Vec2 end_m = goal_m_ - (*last)[last->size() - 2];
    route.poses.push_back({goal_m_, std::atan2(end_m.y(), end_m.x())});
    route.cost = end.cost;
    route.haste = haste_;
    route.nearest_m = goal_m_;
  }

  LegCosts& costs_;
  GroundMap& map_;
  Pose2 start_;
  Vec2 goal_m_;
  const Grain& grain_;
  struct Coarser {
    explicit Coarser(const LegCosts& costs_of_fine)
        : map(costs_of_fine.map().coarser(coarse.spacings)), costs(costs_of_fine.over(map)) {}
    GroundMap map;
    LegCosts costs;
  };
  std::unique_ptr<Coarser> coarser_;
  CostToGo to_go_;
  double radius_m_, cell_m_, step_m_;
  double haste_ = 1;
  double least_ = infinite;  // of the ways that are closed
  bool is_at_border_ = false;
  bool was_cut_ = false;                    // from poses with nothing left to the goal
  std::unordered_set<std::size_t> closed_;  // cells, each with a heading; never gone through
  std::vector<Reached> reached_;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

TurningRoute search_turning(LegCosts& costs, const Pose2& start, const Vec2& goal_m,
                            double radius_m, std::size_t poses_max, const TurningGuide& guide) {
  return Search(costs, start, goal_m, radius_m, guide).run(poses_max);
}

}  // namespace lsos
