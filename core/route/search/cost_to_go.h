// Cost to go: cost from any place on a map to the goal of a leg, the heuristic of a search over
// poses.
#pragma once

#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

#include "route/search/corridor.h"

namespace lsos {

// Costs over the map's lattice, each node connected to its eight neighbours: at most some 8 % above
// those of the cheapest line in any direction. A reverse resumable A* (Silver 2005) expands
// backwards from the goal, towards the start first, and only as far as places are queried. Edges
// are evaluated when they are first in the queue, as in search_grid().
class CostToGo {
 public:
  // Start and goal must be on the map of `costs`. `within`: corridor whose nodes alone are used;
  // null: all nodes.
  CostToGo(RouteCost& costs, const Vec2& start_m, const Vec2& goal_m,
           const Corridor* within = nullptr);

  // Least known cost of the four nodes around a place, at least one of which is expanded. Infinite
  // where they have no route to the goal, or only routes with which the whole route from the start
  // by this place costs more than the limit.
  double at(const Vec2& at_m);
  // Limit of the cost of a route from the start to the goal by a place; infinite at first.
  void set_limit(double cost) { limit_ = cost; }
  // Whether the limit was ever the reason for an infinite cost.
  bool was_limited() const { return was_limited_; }

 private:
  struct Candidate {
    double total = 0;
    double cost = 0;  // lower bound until the edge is evaluated
    std::int32_t node = 0, to = 0;
    bool is_known = false;

    // std::priority_queue returns the greatest element: here the least total, then the node nearest
    // to the goal.
    bool operator<(const Candidate& other) const {
      if (total != other.total) return total > other.total;
      if (cost != other.cost) return cost > other.cost;
      if (node != other.node) return node > other.node;
      return to > other.to;
    }
  };

  std::int32_t number(int column, int row) const { return row * map_.columns() + column; }
  Vec2 place(std::int32_t node) const {
    return map_.place_m(node % map_.columns(), node / map_.columns());
  }
  bool has(int column, int row) const {
    return column >= 0 && row >= 0 && column < map_.columns() && row < map_.rows();
  }
  double height_m(std::int32_t node) {
    return map_.node_m(node % map_.columns(), node / map_.columns());
  }
  bool is_closed(std::int32_t node) const {
    return cost_[static_cast<std::size_t>(node)] < std::numeric_limits<double>::infinity();
  }
  void expand_next();
  // Lower bound of the cost from the start to a node.
  double bound_from_start(std::int32_t node);
  void offer(std::int32_t node, const Candidate& to);
  // Evaluates the edge of a candidate.
  void evaluate(Candidate& candidate);
  void expand(const Candidate& to);

  RouteCost& costs_;
  GroundMap& map_;
  const Corridor* within_;
  Vec2 start_m_;
  double start_height_m_;
  double limit_ = std::numeric_limits<double>::infinity();
  bool was_limited_ = false;
  std::vector<double> cost_;  // infinite where not yet known, or without a route
  std::priority_queue<Candidate> queue_;
};

}  // namespace lsos
