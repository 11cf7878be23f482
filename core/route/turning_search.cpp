#include "route/turning_search.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>
#include <unordered_set>

#include "route/cost_to_go.h"
#include "route/grid_search.h"

namespace lsos {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int headings = 36;
// Curvatures of the edges, in tightest turns; the straight one first. A fast rover slows down much
// for the sharp ones, and hardly for the last.
constexpr double turns[] = {0, 1, -1, 0.5, -0.5, 0.25, -0.25, 0.125, -0.125};
// From this one on it is slow.
constexpr double slow_turn = 0.5;
// The way to the goal is closed from poses that are nearer to it than so many radii.
constexpr double closing_radii = 4;
// What is left to the goal counts so much more than it must: far fewer poses are looked at for a
// route that is no more than about this share costlier. Refining makes up for it.
constexpr double haste = 1.04;

struct Reached {
  Pose2 pose;
  double cost = 0;
  std::int32_t before = -1;
  double curvature_1pm = 0;  // of the edge to it
  LegCosts::Speeds speeds;
};

struct Candidate {
  double total = 0;
  double cost = 0;
  std::int32_t node = 0;
  double closing = 0;  // not 0: the way from the node is closed by an arc of so many tightest turns

  // std::priority_queue takes the greatest: the least total, then the farthest come.
  bool operator<(const Candidate& other) const {
    if (total != other.total) return total > other.total;
    if (cost != other.cost) return cost < other.cost;
    return node > other.node;
  }
};

class Search {
 public:
  Search(LegCosts& costs, const Vec2& start_m, const Vec2& goal_m, double radius_m,
         std::size_t reached_max)
      : reached_max_(reached_max),
        costs_(costs),
        map_(costs.map()),
        goal_m_(goal_m),
        to_go_(costs, start_m, goal_m),
        radius_m_(radius_m),
        step_m_(std::max(2 * std::numbers::pi / headings * radius_m, 1.5 * map_.spacing_m())) {}

  TurningRoute run(const Pose2& start) {
    TurningRoute route;
    double nearest_m = infinite;
    route.nearest_m = start.at_m;
    route.cost = infinite;
    // There are too many poses to look at them all for nothing.
    route.is_cut_off = !std::isfinite(to_go_.at(start.at_m));
    if (route.is_cut_off) return route;
    reached_.push_back({start, 0, -1, 0, {}});
    queue_.push({left(start.at_m), 0, 0});
    while (!queue_.empty() && reached_.size() < reached_max_) {
      const Candidate best = queue_.top();
      queue_.pop();
      if (best.closing != 0) {
        finish(best, route);
        return route;
      }
      const Reached& node = reached_[static_cast<std::size_t>(best.node)];
      const Pose2 pose = node.pose;
      if (!closed_.insert(cell_of(pose, node.curvature_1pm)).second) continue;
      const double off_m = (pose.at_m - goal_m_).norm();
      if (off_m < nearest_m) {
        nearest_m = off_m;
        route.nearest_m = pose.at_m;
      }
      expand(best, pose);
      if (off_m < closing_radii * radius_m_) close(best, pose);
    }
    return route;
  }

 private:
  // Over open ground a line costs as much less than the way over the lattice as it is shorter.
  double left(const Vec2& at_m) {
    const Vec2 way_m = goal_m_ - at_m;
    const double straighter = way_m.norm() / std::max(1e-9, octile_m(way_m));
    return haste * straighter * to_go_.at(at_m);
  }

  // Gentle arcs are longer: each turns by as much as the gentlest of the slow ones.
  double edge_m(double curvature_1pm) const {
    const double turn = std::abs(curvature_1pm) * radius_m_;
    return turn == 0 || turn >= slow_turn ? step_m_ : step_m_ * slow_turn / turn;
  }
  // What a pose costs later depends on the arc that it is come to by: the rover slows down for
  // another one.
  std::size_t cell_of(const Pose2& pose, double curvature_1pm) const {
    const Vec2 cells = (pose.at_m - map_.low_m()) / map_.spacing_m();
    const auto column = std::clamp(std::lround(cells.x()), 0L, map_.columns() - 1L);
    const auto row = std::clamp(std::lround(cells.y()), 0L, map_.rows() - 1L);
    const double turn = pose.yaw_rad / (2 * std::numbers::pi);
    const auto heading =
        static_cast<std::size_t>(std::lround((turn - std::floor(turn)) * headings)) % headings;
    const std::size_t kind = std::abs(curvature_1pm) * radius_m_ < slow_turn ? 0 : 1;
    return (static_cast<std::size_t>(row * map_.columns() + column) * headings + heading) * 2 +
           kind;
  }

  void expand(const Candidate& from, const Pose2& pose) {
    for (const double share : turns) {
      const double curvature_1pm = share / radius_m_;
      const double length_m = edge_m(curvature_1pm);
      const Pose2 to = along_arc(pose, curvature_1pm, length_m);
      if (std::isnan(map_.height_m(to.at_m)) || closed_.contains(cell_of(to, curvature_1pm)))
        continue;
      const Line2 line = arc_line(pose, curvature_1pm, length_m, map_.spacing_m());
      double edge = costs_.along(line);
      if (!std::isfinite(edge)) continue;
      const Reached& node = reached_[static_cast<std::size_t>(from.node)];
      LegCosts::Speeds speeds = node.speeds;
      if (share == 0) {
        speeds.free_m += length_m;
      } else {
        // From one side to the other the points of the line go straight on.
        if (share * node.curvature_1pm < 0) {
          speeds.free_m += length_m / static_cast<double>(line.size() - 1);
        }
        edge += costs_.arc(speeds, radius_m_ / std::abs(share), length_m * std::abs(curvature_1pm));
      }
      const double left = this->left(to.at_m);
      if (!std::isfinite(left)) continue;
      reached_.push_back({to, from.cost + edge, from.node, curvature_1pm, speeds});
      queue_.push({from.cost + edge + left, from.cost + edge,
                   static_cast<std::int32_t>(reached_.size() - 1)});
    }
  }

  void close(const Candidate& from, const Pose2& pose) {
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
      queue_.push({cost, cost, from.node, share});
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
    const auto last = arc_and_straight(way.back().pose, goal_m_, radius_m_ / std::abs(end.closing),
                                       end.closing > 0, map_.spacing_m());
    route.line.insert(route.line.end(), last->begin() + 1, last->end());
    const Vec2 end_m = goal_m_ - (*last)[last->size() - 2];
    route.poses.push_back({goal_m_, std::atan2(end_m.y(), end_m.x())});
    route.cost = end.cost;
    route.nearest_m = goal_m_;
  }

  std::size_t reached_max_;
  LegCosts& costs_;
  GroundMap& map_;
  Vec2 goal_m_;
  CostToGo to_go_;
  double radius_m_, step_m_;
  double least_ = infinite;
  std::unordered_set<std::size_t> closed_;  // cells, each with a heading; never gone through
  std::vector<Reached> reached_;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

TurningRoute search_turning(LegCosts& costs, const Pose2& start, const Vec2& goal_m,
                            double radius_m, std::size_t reached_max) {
  return Search(costs, start.at_m, goal_m, radius_m, reached_max).run(start);
}

}  // namespace lsos
