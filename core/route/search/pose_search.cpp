#include "route/search/pose_search.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <queue>
#include <span>
#include <unordered_set>

#include "base/rounding.h"
#include "route/search/cost_to_go.h"
#include "route/search/grid_search.h"

namespace lsos {

namespace {

// Curvatures of the edges, in units of the tightest; the straight one first. A fast rover slows
// down much for the sharp ones, and hardly for the last.
constexpr double turns[] = {0, 1, -1, 0.5, -0.5, 0.25, -0.25, 0.125, -0.125};
// Curvature from which an edge counts as sharp: the rover is slow on it.
constexpr double sharp_turn = 0.5;
// Distance from the goal, in radii, below which analytic expansion is tried.
constexpr double expansion_radii = 4;
// Weighted A*: the heuristic is multiplied by `weight`, so the route costs at most about that much
// more and far fewer poses are expanded; refinement makes up for it. A stage that expands `poses`
// without reaching the goal is followed by one with a greater weight.
struct SearchStage {
  double weight;
  std::size_t poses;
};
constexpr SearchStage fine_stages[] = {
    {1.04, 60'000}, {1.1, 40'000}, {1.2, 60'000}, {1.4, 360'000}};
// Coarse resolution has an eighth of the poses. Lower weights find no route over rough ground, and
// refinement makes the routes as good.
constexpr SearchStage coarse_stages[] = {{1.2, 15'000}, {1.5, 15'000}, {2, 60'000}};

// Resolution of the search: each pose stands for all that lie in its cell.
struct Resolution {
  int spacings;  // side of a cell, and spacing for the cost to go, in map spacings
  int headings;
  std::span<const SearchStage> stages;
};
constexpr Resolution fine{1, 36, fine_stages}, coarse{2, 18, coarse_stages};

// Detour bounds: a pose is not expanded where the route over the lattice by it costs more than
// `detour_bounds` times the cheapest, plus `detour_turns` full turns. Without a bound a rover that
// cannot get on would have the whole map expanded. The larger bound applies where nothing else is
// left.
constexpr double detour_bounds[] = {1.5, 4}, detour_turns = 1.5;

struct Reached {
  Pose2 pose;  // of the rover, which backs up against its heading
  double cost = 0;
  std::int32_t before = -1;
  double curvature_1pm = 0;  // of the edge to it, positive to the left of the direction of travel
  bool is_backward = false;
  RouteCost::ArcState speeds;
};

// Whether backwards, of the gears that are tried.
constexpr std::array<bool, 2> gears{false, true};

// Entry of the queue: a pose; an edge from a pose, whose cost is a lower bound until it is
// evaluated; or a complete route, by analytic expansion from a pose.
struct PoseCandidate {
  enum class Kind : std::uint8_t { pose, edge, to_goal };
  double total = 0;
  double cost = 0;
  std::int32_t node = 0;
  Kind kind = Kind::pose;
  double turn = 0;  // curvature of an edge or of the arc to the goal, in units of the tightest
  bool is_backward = false;

  // std::priority_queue returns the greatest element: here the least total, then the greatest cost
  // so far.
  bool operator<(const PoseCandidate& other) const {
    if (total != other.total) return total > other.total;
    if (cost != other.cost) return cost < other.cost;
    if (node != other.node) return node > other.node;
    if (turn != other.turn) return turn > other.turn;
    return is_backward && !other.is_backward;
  }
};

class PoseGraphSearch {
 public:
  PoseGraphSearch(RouteCost& costs, const Pose2& start, const Vec2& goal_m, double radius_m,
                  const PoseGuide& guide)
      : costs_(costs),
        backing_(costs.backing()),
        map_(costs.map()),
        gears_(std::span(gears).first(guide.may_reverse ? 2 : 1)),
        start_(start),
        goal_m_(goal_m),
        resolution_(guide.is_coarse ? coarse : fine),
        coarser_(guide.is_coarse ? std::make_unique<Coarser>(costs) : nullptr),
        to_go_(coarser_ ? coarser_->costs : costs, start.at_m, goal_m, guide.within),
        radius_m_(radius_m),
        cell_m_(resolution_.spacings * map_.spacing_m()),
        step_m_(std::max(2 * std::numbers::pi / resolution_.headings * radius_m, 1.5 * cell_m_)) {}

  PoseRoute run(std::size_t poses_max) {
    PoseRoute route;
    route.nearest_m = start_.at_m;
    route.cost = infinite;
    // Without a route over the lattice there is none over poses, and those are too many to expand
    // in vain.
    const double least = to_go_.at(start_.at_m);
    if (!std::isfinite(least)) return route;
    const double far_m = std::max(step_m_, (goal_m_ - start_.at_m).norm());
    const double turning = detour_turns * 2 * std::numbers::pi * radius_m_ *
                           std::max(least / far_m, costs_.steep_per_metre());
    std::size_t poses_left = poses_max;
    for (const double detour_bound : detour_bounds) {
      to_go_.set_limit(detour_bound * least + turning);
      if (!run_stages(poses_left, route)) return route;
      if (!to_go_.was_limited()) break;
    }
    route.is_start_blocked = reached_.size() == 1;
    route.is_at_border = is_at_border_;
    return route;
  }

 private:
  // Whether all poses that can be reached were expanded without reaching the goal. Subtracts the
  // number of expanded poses from `left`.
  bool run_stages(std::size_t& left, PoseRoute& route) {
    for (const SearchStage& stage : resolution_.stages) {
      begin(stage.weight);
      const bool is_found = reach_goal(std::min(stage.poses, left), route);
      left -= std::min(left, closed_.size());
      route.expanded += closed_.size();
      if (is_found) return false;
      if (queue_.empty()) return true;
    }
    return false;
  }

  void begin(double weight) {
    weight_ = weight;
    least_ = infinite;
    is_at_border_ = false;
    closed_.clear();
    reached_.clear();
    queue_ = {};
    reached_.push_back({start_, 0, -1, 0, false, {}});
    queue_.push({left(start_.at_m), 0, 0});
  }

  // Whether the goal is reached within `poses` expansions.
  bool reach_goal(std::size_t poses, PoseRoute& route) {
    while (!queue_.empty() && closed_.size() < poses) {
      const PoseCandidate best = queue_.top();
      queue_.pop();
      if (best.kind == PoseCandidate::Kind::to_goal) {
        finish(best, route);
        return true;
      }
      if (best.kind == PoseCandidate::Kind::edge) {
        evaluate(best);
        continue;
      }
      const Reached& node = reached_[static_cast<std::size_t>(best.node)];
      const Pose2 pose = node.pose;
      if (!closed_.insert(cell_of(pose, node.curvature_1pm, node.is_backward)).second) continue;
      const double off_m = (pose.at_m - goal_m_).norm();
      if (off_m < (route.nearest_m - goal_m_).norm()) route.nearest_m = pose.at_m;
      expand(best, pose);
      if (off_m < expansion_radii * radius_m_) expand_to_goal(best, pose);
    }
    return false;
  }

  // Heuristic. Over open ground a straight line is shorter than the route over the lattice, and
  // cheaper in the same ratio.
  double left(const Vec2& at_m) {
    const Vec2 delta_m = goal_m_ - at_m;
    const double straighter = delta_m.norm() / std::max(1e-9, octile_m(delta_m));
    return weight_ * straighter * to_go_.at(at_m);
  }

  // Gentle arcs are longer: each turns by the angle of the gentlest sharp one.
  double edge_m(double curvature_1pm) const {
    const double turn = std::abs(curvature_1pm) * radius_m_;
    return turn == 0 || turn >= sharp_turn ? step_m_ : step_m_ * sharp_turn / turn;
  }
  // Poses reached by sharp and by gentle arcs have separate cells: what a pose costs later depends
  // on the arc to it, since the rover slows down for another one.
  std::size_t cell_of(const Pose2& pose, double curvature_1pm, bool is_backward) const {
    const Vec2 cells = (pose.at_m - map_.low_m()) / cell_m_;
    const auto column = std::clamp(std::lround(cells.x()), 0L, map_.columns() - 1L);
    const auto row = std::clamp(std::lround(cells.y()), 0L, map_.rows() - 1L);
    const double turn = pose.yaw_rad / (2 * std::numbers::pi);
    const long heading =
        std::lround((turn - std::floor(turn)) * resolution_.headings) % resolution_.headings;
    const long kind = std::abs(curvature_1pm) * radius_m_ < sharp_turn ? 0 : 1;
    return static_cast<std::size_t>(
        ((row * map_.columns() + column) * resolution_.headings + heading) * 4 +
        (is_backward ? 2 : 0) + kind);
  }

  // Edges are queued by a lower bound of their cost; most are never evaluated.
  void expand(const PoseCandidate& from, const Pose2& pose) {
    const double height_m = map_.height_m(pose.at_m);
    for (const bool is_backward : gears_) {
      for (const double turn : turns) {
        const double curvature_1pm = turn / radius_m_;
        const Pose2 to = after_edge(pose, curvature_1pm, is_backward);
        is_at_border_ = is_at_border_ || costs_.is_at_border(to.at_m);
        const double rise_m = map_.height_m(to.at_m) - height_m;
        if (std::isnan(rise_m)) continue;
        if (closed_.contains(cell_of(to, curvature_1pm, is_backward))) continue;
        const double left = this->left(to.at_m);
        if (!std::isfinite(left)) continue;
        const double cost = from.cost + costs_.least((to.at_m - pose.at_m).norm(), rise_m) +
                            arc(from.node, turn, is_backward).cost;
        queue_.push({cost + left, cost, from.node, PoseCandidate::Kind::edge, turn, is_backward});
      }
    }
  }

  Pose2 after_edge(const Pose2& from, double curvature_1pm, bool is_backward) const {
    return standing(along_arc(travelling(from, is_backward), curvature_1pm, edge_m(curvature_1pm)),
                    is_backward);
  }
  Line2 edge_line(const Pose2& from, double curvature_1pm, bool is_backward) const {
    return arc_line(travelling(from, is_backward), curvature_1pm, edge_m(curvature_1pm),
                    map_.spacing_m());
  }
  RouteCost& costs_of(bool is_backward) { return is_backward ? backing_ : costs_; }

  // Cost of slowing down for an edge, and the speeds after it.
  struct EdgeArc {
    double cost = 0;
    RouteCost::ArcState speeds;
  };
  EdgeArc arc(std::int32_t from, double turn, bool is_backward) const {
    const Reached& node = reached_[static_cast<std::size_t>(from)];
    const double curvature_1pm = turn / radius_m_, length_m = edge_m(curvature_1pm);
    const bool changes = is_backward != node.is_backward;
    EdgeArc arc{costs_.gear_changes(changes ? 1 : 0),
                changes ? RouteCost::ArcState{} : node.speeds};
    if (turn == 0) {
      arc.speeds.free_m += length_m;
      return arc;
    }
    // Between arcs to opposite sides, one piece of the line is straight.
    if (!changes && turn * node.curvature_1pm < 0) {
      arc.speeds.free_m += length_m / arc_pieces(curvature_1pm, length_m, map_.spacing_m());
    }
    arc.cost +=
        costs_.arc(arc.speeds, 1 / std::abs(curvature_1pm), length_m * std::abs(curvature_1pm));
    return arc;
  }

  void evaluate(const PoseCandidate& edge) {
    const Reached& from = reached_[static_cast<std::size_t>(edge.node)];
    const double curvature_1pm = edge.turn / radius_m_;
    const bool is_backward = edge.is_backward;
    const Pose2 to = after_edge(from.pose, curvature_1pm, is_backward);
    if (closed_.contains(cell_of(to, curvature_1pm, is_backward))) return;
    const double along =
        costs_of(is_backward).along(edge_line(from.pose, curvature_1pm, is_backward));
    if (!std::isfinite(along)) return;
    const EdgeArc arc = this->arc(edge.node, edge.turn, is_backward);
    const double cost = from.cost + along + arc.cost;
    reached_.push_back({to, cost, edge.node, curvature_1pm, is_backward, arc.speeds});
    queue_.push({cost + left(to.at_m), cost, static_cast<std::int32_t>(reached_.size() - 1)});
  }

  void expand_to_goal(const PoseCandidate& from, const Pose2& pose) {
    const Vec2 delta_m = goal_m_ - pose.at_m;
    const double rise_m = map_.height_m(goal_m_) - map_.height_m(pose.at_m);
    if (!(from.cost + costs_.least(delta_m.norm(), rise_m) < least_)) return;
    for (const bool is_backward : gears_) {
      for (const double share : turns) {
        if (share != 0) offer_to_goal(from, pose, share, is_backward);
      }
    }
  }

  void offer_to_goal(const PoseCandidate& from, const Pose2& pose, double share, bool is_backward) {
    const double radius_m = radius_m_ / std::abs(share);
    const auto line = last_piece(pose, share, is_backward);
    if (!line) return;
    const Reached& node = reached_[static_cast<std::size_t>(from.node)];
    const bool changes = is_backward != node.is_backward;
    double cost =
        from.cost + costs_.gear_changes(changes ? 1 : 0) + costs_of(is_backward).along(*line);
    double turn_m = 0;
    for (std::size_t k = 0; k + 2 < line->size(); ++k) {
      turn_m += ((*line)[k + 1] - (*line)[k]).norm();
    }
    RouteCost::ArcState speeds = changes ? RouteCost::ArcState{} : node.speeds;
    if (turn_m > 0) cost += costs_.arc(speeds, radius_m, turn_m / radius_m);
    if (!(cost < least_)) return;
    least_ = cost;
    queue_.push({cost, cost, from.node, PoseCandidate::Kind::to_goal, share, is_backward});
  }

  std::optional<Line2> last_piece(const Pose2& pose, double share, bool is_backward) const {
    return arc_and_straight(travelling(pose, is_backward), goal_m_, radius_m_ / std::abs(share),
                            share > 0, map_.spacing_m());
  }

  void finish(const PoseCandidate& end, PoseRoute& route) const {
    std::vector<Reached> way;
    for (std::int32_t node = end.node; node >= 0;) {
      way.push_back(reached_[static_cast<std::size_t>(node)]);
      node = way.back().before;
    }
    std::ranges::reverse(way);
    for (std::size_t k = 1; k < way.size(); ++k) {
      const bool is_backward = way[k].is_backward;
      add(route, way[k - 1].pose, edge_line(way[k - 1].pose, way[k].curvature_1pm, is_backward),
          travelling(way[k].pose, is_backward), is_backward);
    }
    const Line2 last = *last_piece(way.back().pose, end.turn, end.is_backward);
    const Vec2 end_m = goal_m_ - last[last.size() - 2];
    add(route, way.back().pose, last, {goal_m_, std::atan2(end_m.y(), end_m.x())}, end.is_backward);
    route.cost = end.cost;
    route.weight = weight_;
    route.nearest_m = goal_m_;
  }

  // Adds a piece to a route; where the gear changes, a stretch begins with the pose `from`.
  static void add(PoseRoute& route, const Pose2& from, const Line2& piece, const Pose2& travel_to,
                  bool is_backward) {
    if (!route.is_found() || route.stretches.back().is_backward != is_backward) {
      route.stretches.push_back({{travelling(from, is_backward)}, {from.at_m}, is_backward});
    }
    Stretch& stretch = route.stretches.back();
    stretch.line.insert(stretch.line.end(), piece.begin() + 1, piece.end());
    stretch.poses.push_back(travel_to);
  }

  RouteCost& costs_;
  RouteCost backing_;  // of driving backwards
  GroundMap& map_;
  std::span<const bool> gears_;
  Pose2 start_;
  Vec2 goal_m_;
  const Resolution& resolution_;
  struct Coarser {
    explicit Coarser(const RouteCost& costs_of_fine)
        : map(costs_of_fine.map().coarser(coarse.spacings)), costs(costs_of_fine.over(map)) {}
    GroundMap map;
    RouteCost costs;
  };
  std::unique_ptr<Coarser> coarser_;
  CostToGo to_go_;
  double radius_m_, cell_m_, step_m_;
  double weight_ = 1;
  double least_ = infinite;  // least cost of the complete routes
  bool is_at_border_ = false;
  std::unordered_set<std::size_t> closed_;  // cells, each with a heading; never iterated
  std::vector<Reached> reached_;
  std::priority_queue<PoseCandidate> queue_;
};

}  // namespace

PoseRoute search_poses(RouteCost& costs, const Pose2& start, const Vec2& goal_m, double radius_m,
                       std::size_t poses_max, const PoseGuide& guide) {
  return PoseGraphSearch(costs, start, goal_m, radius_m, guide).run(poses_max);
}

}  // namespace lsos
