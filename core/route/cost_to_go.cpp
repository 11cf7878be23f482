#include "route/cost_to_go.h"

#include <limits>

#include "route/grid_search.h"

namespace lsos {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

CostToGo::CostToGo(LegCosts& costs, const Vec2& start_m, const Vec2& goal_m)
    : costs_(costs),
      map_(costs.map()),
      start_m_(start_m),
      start_height_m_(map_.height_m(start_m)),
      cost_(static_cast<std::size_t>(map_.columns()) * static_cast<std::size_t>(map_.rows()),
            infinite),
      is_closed_(cost_.size(), false) {
  const Vec2 cells = (goal_m - map_.low_m()) / map_.spacing_m();
  const int column = static_cast<int>(std::floor(cells.x()));
  const int row = static_cast<int>(std::floor(cells.y()));
  for (int x = column; x <= column + 1; ++x) {
    for (int y = row; y <= row + 1; ++y) {
      if (has(x, y)) offer(number(x, y), costs_.straight(map_.place_m(x, y), goal_m));
    }
  }
}

double CostToGo::at(const Vec2& at_m) {
  const Vec2 cells = (at_m - map_.low_m()) / map_.spacing_m();
  const int column = static_cast<int>(std::floor(cells.x()));
  const int row = static_cast<int>(std::floor(cells.y()));
  double least = infinite;
  for (int x = column; x <= column + 1; ++x) {
    for (int y = row; y <= row + 1; ++y) {
      if (has(x, y)) least = std::min(least, of_node(number(x, y)));
    }
  }
  return least;
}

double CostToGo::of_node(std::int32_t node) {
  const auto wanted = static_cast<std::size_t>(node);
  while (!is_closed_[wanted] && !queue_.empty()) {
    const Candidate best = queue_.top();
    queue_.pop();
    if (!is_closed_[static_cast<std::size_t>(best.node)]) expand(best);
  }
  return is_closed_[wanted] ? cost_[wanted] : infinite;
}

double CostToGo::come(std::int32_t node) {
  const double rise_m = map_.node_m(node % map_.columns(), node / map_.columns()) - start_height_m_;
  return std::max(0.0, costs_.least_per_metre() * octile_m(place(node) - start_m_) +
                           costs_.per_rise() * rise_m);
}

void CostToGo::offer(std::int32_t node, double cost) {
  double& known = cost_[static_cast<std::size_t>(node)];
  if (!(cost < known)) return;
  known = cost;
  queue_.push({cost + come(node), cost, node});
}

void CostToGo::expand(const Candidate& from) {
  is_closed_[static_cast<std::size_t>(from.node)] = true;
  const int column = from.node % map_.columns(), row = from.node / map_.columns();
  for (int x = column - 1; x <= column + 1; ++x) {
    for (int y = row - 1; y <= row + 1; ++y) {
      if (!has(x, y) || is_closed_[static_cast<std::size_t>(number(x, y))]) continue;
      if (std::isnan(map_.node_m(x, y))) continue;
      offer(number(x, y), from.cost + costs_.straight(map_.place_m(x, y), place(from.node)));
    }
  }
}

}  // namespace lsos
