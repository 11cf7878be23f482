// What it costs from anywhere on a map to the goal of a leg: what guides a search over poses.
#pragma once

#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

#include "route/search/tube.h"

namespace lsos {

// Over the map's lattice, each node to its eight neighbours: at most some 8 % more than the
// cheapest line in any direction. Looked for backwards from the goal, towards the start first, and
// no farther than what is asked for (Silver 2005, reverse resumable A*), edges when they come first
// as in search_grid().
class CostToGo {
 public:
  // Start and goal must be on the map of `costs`. `within`: over its nodes only.
  CostToGo(LegCosts& costs, const Vec2& start_m, const Vec2& goal_m, const Tube* within = nullptr);

  // The least known of the nodes about a place, one at least; infinite where none has a way, or
  // only one that makes the way from the start by this place cost more than the limit.
  double at(const Vec2& at_m);
  // Of the way from the start to the goal by a place; infinite at first.
  void set_limit(double cost) { limit_ = cost; }
  // Whether the limit ever was the reason.
  bool was_limited() const { return was_limited_; }

 private:
  struct Candidate {
    double total = 0;
    double cost = 0;  // a bound until the edge is known
    std::int32_t node = 0, to = 0;
    bool is_known = false;

    // std::priority_queue takes the greatest: the least total, then the one nearest to the goal.
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
  void look_on();
  // Of the way from the start.
  double come(std::int32_t node);
  void offer(std::int32_t node, const Candidate& to);
  // Works out the edge of a candidate.
  void look(Candidate& candidate);
  void expand(const Candidate& to);

  LegCosts& costs_;
  GroundMap& map_;
  const Tube* within_;
  Vec2 start_m_;
  double start_height_m_;
  double limit_ = std::numeric_limits<double>::infinity();
  bool was_limited_ = false;
  std::vector<double> cost_;  // infinite where it is not known yet, or there is no way
  std::priority_queue<Candidate> queue_;
};

}  // namespace lsos
