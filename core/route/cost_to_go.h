// What it costs from anywhere on a map to the goal of a leg: what guides a search over poses.
#pragma once

#include <cstdint>
#include <queue>

#include "route/leg_cost.h"

namespace lsos {

// Over the map's lattice, each node to its eight neighbours: at most some 8 % more than the
// cheapest line in any direction. Looked for backwards from the goal, towards the start first, and
// no farther than what is asked for (Silver 2005, reverse resumable A*).
class CostToGo {
 public:
  // Start and goal must be on the map of `costs`.
  CostToGo(LegCosts& costs, const Vec2& start_m, const Vec2& goal_m);

  // The least of the nodes about a place; infinite where none of them has a way.
  double at(const Vec2& at_m);

 private:
  struct Candidate {
    double total = 0, cost = 0;
    std::int32_t node = 0;

    // std::priority_queue takes the greatest: the least total, then the one nearest to the goal.
    bool operator<(const Candidate& other) const {
      if (total != other.total) return total > other.total;
      if (cost != other.cost) return cost > other.cost;
      return node > other.node;
    }
  };

  std::int32_t number(int column, int row) const { return row * map_.columns() + column; }
  Vec2 place(std::int32_t node) const {
    return map_.place_m(node % map_.columns(), node / map_.columns());
  }
  bool has(int column, int row) const {
    return column >= 0 && row >= 0 && column < map_.columns() && row < map_.rows();
  }
  double of_node(std::int32_t node);
  // A bound of the cost from the start.
  double come(std::int32_t node);
  void offer(std::int32_t node, double cost);
  void expand(const Candidate& from);

  LegCosts& costs_;
  GroundMap& map_;
  Vec2 start_m_;
  double start_height_m_;
  std::vector<double> cost_;
  std::vector<bool> is_closed_;
  std::priority_queue<Candidate> queue_;
};

}  // namespace lsos
