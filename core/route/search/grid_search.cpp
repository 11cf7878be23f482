#include "route/search/grid_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>

#include "base/rounding.h"
#include "route/map/tiled_grid.h"
#include "route/search/corridor.h"

namespace lsos {

namespace {

constexpr std::array<std::array<int, 2>, 8> neighbours{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
constexpr std::uint8_t no_direction = 255, to_goal = 8;
// Cost quantum, as a share of the lower bound of the cost of the whole route.
constexpr double cost_quantum_share = 1e-9;
// A route over more than `corridor_nodes` nodes, and any route on a map of more than `map_nodes`,
// is searched in a corridor around the route over a lattice `coarser_times` as coarse,
// `corridors_spacings` of the finer spacing to either side. For SEV over 800 m of LunarSouthPole
// (the test RoughSearch) that expands a fortieth of the nodes, for a route that costs at most 2 %
// more than the cheapest.
constexpr double corridor_nodes = 150;
constexpr int map_nodes = 100'000;
constexpr int coarser_times = 4;
// Wider ones are tried where that has no route, since the coarser map does not show all hazards: on
// legs of 600 m over LunarSouthPole the whole map takes some ten seconds then.
constexpr double corridors_spacings[] = {10, 40, 160};
// Where the route in the corridor costs more than `trusted_ratio` times the coarser one, the
// coarser map does not show what matters, and the next corridor is tried, or the whole map; unless
// the last one gained less than this share.
constexpr double trusted_ratio = 1.25, gain_share = 0.05;

struct NodeCandidate {
  double total = 0;     // estimated cost of a whole route through it
  double cost = 0;      // to the node; a lower bound until the edge is evaluated
  float tie_break = 0;  // tie-break: of equal totals the greatest comes first
  std::int32_t node = 0;
  std::uint8_t direction = no_direction;  // of the edge to it
  bool is_known = false;

  // std::priority_queue returns the greatest element: here the least total.
  bool operator<(const NodeCandidate& other) const {
    if (total != other.total) return total > other.total;
    if (tie_break != other.tie_break) return tie_break < other.tie_break;
    if (node != other.node) return node > other.node;
    return direction > other.direction;
  }
};

class NodeSearch {
 public:
  // `within`: corridor whose nodes alone are used; null: all nodes.
  NodeSearch(RouteCost& costs, const Vec2& start_m, const Vec2& goal_m,
             const Corridor* within = nullptr)
      : costs_(costs),
        map_(costs.map()),
        within_(within),
        start_m_(start_m),
        goal_m_(goal_m),
        goal_height_m_(map_.height_m(goal_m)),
        goal_node_(map_.columns() * map_.rows()),
        nodes_(map_.columns(), map_.rows()) {
    start_ = number(column(start_m), row(start_m));
    find_goal_neighbours();
    cost_quantum_ = cost_quantum_share * heuristic(start_);
  }

  GridRoute run() {
    GridRoute route;
    double nearest_m = infinite;
    node(start_).cost = 0;
    queue_.push({heuristic(start_), 0, 0, start_, no_direction, true});
    while (!queue_.empty()) {
      NodeCandidate best = queue_.top();
      queue_.pop();
      Node& node = this->node(best.node);
      if (node.is_closed || (!best.is_known && !(best.cost < node.cost))) continue;
      if (!best.is_known) {
        evaluate(best);
        continue;
      }
      node.is_closed = true;
      node.cost = best.cost;
      node.parent_direction = best.direction;
      ++route.expanded;
      if (best.node == goal_node_) {
        route.line = line();
        route.cost = best.cost;
        route.nearest_m = goal_m_;
        return route;
      }
      const double off_m = (place(best.node) - goal_m_).norm();
      if (off_m < nearest_m && can_stand(best)) {
        nearest_m = off_m;
        route.nearest_m = place(best.node);
      }
      expand(best);
    }
    route.cost = infinite;
    return route;
  }

 private:
  struct Node {
    double cost = infinite;  // least of the evaluated edges
    double heuristic = std::numeric_limits<double>::quiet_NaN();
    bool is_closed = false;
    std::uint8_t parent_direction = no_direction;
  };
  Node& node(std::int32_t node) {
    return node == goal_node_ ? goal_ : nodes_(node % map_.columns(), node / map_.columns());
  }

  // Column and row of the nearest node.
  int column(const Vec2& at_m) const {
    return std::clamp(static_cast<int>(std::lround(map_.nodes(at_m).x())), 0, map_.columns() - 1);
  }
  int row(const Vec2& at_m) const {
    return std::clamp(static_cast<int>(std::lround(map_.nodes(at_m).y())), 0, map_.rows() - 1);
  }
  std::int32_t number(int column, int row) const { return row * map_.columns() + column; }
  Vec2 place(std::int32_t node) const {
    return node == goal_node_ ? goal_m_
                              : map_.place_m(node % map_.columns(), node / map_.columns());
  }
  double height_m(std::int32_t node) {
    return node == goal_node_ ? goal_height_m_
                              : map_.node_m(node % map_.columns(), node / map_.columns());
  }
  std::int32_t before(const NodeCandidate& c) const {
    if (c.direction == to_goal) return last_;
    const auto& way = neighbours[c.direction];
    return c.node - number(way[0], way[1]);
  }
  // A goal at a node, but for rounding, is reached from all neighbours of that node.
  bool is_next_to_goal(const Vec2& at_m) const {
    return (at_m - goal_m_).cwiseAbs().maxCoeff() <= 1.01 * map_.spacing_m();
  }
  void find_goal_neighbours() {
    const int column = this->column(goal_m_), row = this->row(goal_m_);
    for (int y = std::max(0, row - 1); y <= std::min(map_.rows() - 1, row + 1); ++y) {
      for (int x = std::max(0, column - 1); x <= std::min(map_.columns() - 1, column + 1); ++x) {
        const Vec2 at_m = map_.place_m(x, y);
        if (is_next_to_goal(at_m)) goal_neighbours_.push_back({at_m, (goal_m_ - at_m).norm()});
      }
    }
  }
  // Length of the shortest path to the goal: along the lattice to a node from which the goal is
  // reached. A weaker bound would make the search expand all of the equally short routes over level
  // ground.
  double distance_to_goal_m(std::int32_t node) const {
    if (node == goal_node_) return 0;
    double least_m = infinite;
    for (const GoalNeighbour& neighbour : goal_neighbours_) {
      least_m = std::min(least_m, octile_m(neighbour.at_m - place(node)) + neighbour.to_goal_m);
    }
    return least_m;
  }
  // Lower bound of the cost to go.
  double heuristic(std::int32_t node) {
    double& heuristic = this->node(node).heuristic;
    if (std::isnan(heuristic)) heuristic = compute_heuristic(node);
    return heuristic;
  }
  double compute_heuristic(std::int32_t node) {
    const double distance_to_goal_m = this->distance_to_goal_m(node);
    const double rise_m = goal_height_m_ - height_m(node);
    return std::isnan(rise_m) ? costs_.least_per_metre() * distance_to_goal_m
                              : costs_.least(distance_to_goal_m, rise_m);
  }

  // Rounded to the cost quantum: routes of the same cost must not differ by rounding errors, which
  // depend on the order of their steps.
  double total(double cost, std::int32_t node) {
    const double total = cost + heuristic(node);
    return cost_quantum_ > 0 ? cost_quantum_ * std::round(total / cost_quantum_) : total;
  }

  // Tie-break that prefers nodes far along and close to the straight line: over level ground such
  // routes need the least refinement.
  float tie_break(double cost, std::int32_t node) const {
    const Vec2 delta_m = place(node) - start_m_, whole_m = goal_m_ - start_m_;
    const double aside_m = std::abs(delta_m.x() * whole_m.y() - delta_m.y() * whole_m.x());
    const double length_m = std::max(whole_m.norm(), 1e-9);
    return static_cast<float>(cost / costs_.least_per_metre() - aside_m / length_m);
  }

  void offer(const NodeCandidate& from, std::int32_t to, std::uint8_t direction) {
    Node& node = this->node(to);
    if (node.is_closed) return;
    if (within_ != nullptr && !within_->holds(place(to))) return;
    const double rise_m = height_m(to) - height_m(from.node);
    if (std::isnan(rise_m)) return;
    const double cost = from.cost + costs_.least((place(to) - place(from.node)).norm(), rise_m);
    if (!(cost < node.cost)) return;
    queue_.push({total(cost, to), cost, tie_break(cost, to), to, direction, false});
  }

  bool can_stand(const NodeCandidate& at) {
    if (at.direction == no_direction) return true;
    const auto& way = neighbours[at.direction];
    return costs_.can_stand(place(at.node), Vec2(way[0], way[1]).normalized());
  }

  void expand(const NodeCandidate& from) {
    const int column = from.node % map_.columns(), row = from.node / map_.columns();
    for (std::uint8_t k = 0; k < to_goal; ++k) {
      const int x = column + neighbours[k][0], y = row + neighbours[k][1];
      if (x < 0 || y < 0 || x >= map_.columns() || y >= map_.rows()) continue;
      offer(from, number(x, y), k);
    }
    if (!is_next_to_goal(place(from.node))) return;
    const double cost = from.cost + costs_.straight(place(from.node), goal_m_);
    if (!(cost < goal_.cost)) return;
    goal_.cost = cost;
    last_ = from.node;
    queue_.push(
        {total(cost, goal_node_), cost, tie_break(cost, goal_node_), goal_node_, to_goal, true});
  }

  // Evaluates the edge of a candidate.
  void evaluate(NodeCandidate& candidate) {
    const std::int32_t from = before(candidate);
    candidate.cost = node(from).cost + costs_.straight(place(from), place(candidate.node));
    Node& to = node(candidate.node);
    if (!(candidate.cost < to.cost)) return;
    to.cost = candidate.cost;
    candidate.total = total(candidate.cost, candidate.node);
    candidate.tie_break = tie_break(candidate.cost, candidate.node);
    candidate.is_known = true;
    queue_.push(candidate);
  }

  Line2 line() {
    Line2 line{goal_m_};
    std::int32_t node = last_;
    for (;;) {
      line.push_back(place(node));
      const std::uint8_t direction = this->node(node).parent_direction;
      if (direction == no_direction) break;
      node -= number(neighbours[direction][0], neighbours[direction][1]);
    }
    std::ranges::reverse(line);
    return line;
  }

  RouteCost& costs_;
  GroundMap& map_;
  const Corridor* within_;
  Vec2 start_m_, goal_m_;
  double goal_height_m_;
  struct GoalNeighbour {
    Vec2 at_m;
    double to_goal_m;
  };
  std::vector<GoalNeighbour> goal_neighbours_;  // nodes from which the goal is reached
  double cost_quantum_ = 0;                     // cost quantum of totals
  std::int32_t start_ = 0, goal_node_, last_ = 0;
  TiledGrid<Node> nodes_;
  Node goal_;
  std::priority_queue<NodeCandidate> queue_;
};

}  // namespace

double octile_m(const Vec2& delta_m) {
  const double x = std::abs(delta_m.x()), y = std::abs(delta_m.y());
  return std::max(x, y) + (std::numbers::sqrt2 - 1) * std::min(x, y);
}

GridRoute search_grid(RouteCost& costs, const Vec2& start_m, const Vec2& goal_m) {
  const GroundMap& map = costs.map();
  const double spacing_m = map.spacing_m();
  std::size_t expanded = 0;
  const bool is_long = octile_m(goal_m - start_m) > corridor_nodes * spacing_m;
  if (is_long || map.columns() * map.rows() > map_nodes) {
    GroundMap coarser_map = map.guide(coarser_times);
    RouteCost coarser = costs.over(coarser_map);
    const GridRoute way = search_grid(coarser, start_m, goal_m);
    expanded += way.expanded;
    double cost_before = infinite;
    for (const double off_spacings : corridors_spacings) {
      if (way.line.empty()) break;
      const Corridor corridor(map, way.line, off_spacings * spacing_m);
      GridRoute route = NodeSearch(costs, start_m, goal_m, &corridor).run();
      expanded += route.expanded;
      route.expanded = expanded;
      const bool is_settled =
          std::isfinite(cost_before) && route.cost > (1 - gain_share) * cost_before;
      if (route.cost < trusted_ratio * way.cost || is_settled) return route;
      cost_before = route.cost;
    }
  }
  GridRoute route = NodeSearch(costs, start_m, goal_m).run();
  route.expanded += expanded;
  return route;
}

}  // namespace lsos
