#include "route/search/cost_to_go.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/rounding.h"
#include "route/search/grid_search.h"

namespace lsos {

namespace {}  // namespace

CostToGo::CostToGo(RouteCost& costs, const Vec2& start_m, const Vec2& goal_m,
                   const Corridor* within)
    : costs_(costs),
      map_(costs.map()),
      within_(within),
      start_m_(start_m),
      start_height_m_(map_.height_m(start_m)),
      cost_(static_cast<std::size_t>(map_.columns()) * static_cast<std::size_t>(map_.rows()),
            infinite) {
  const Vec2 cells = (goal_m - map_.low_m()) / map_.spacing_m();
  const int column = static_cast<int>(std::floor(cells.x()));
  const int row = static_cast<int>(std::floor(cells.y()));
  for (int x = column; x <= column + 1; ++x) {
    for (int y = row; y <= row + 1; ++y) {
      if (!has(x, y)) continue;
      const double cost = costs_.straight(map_.place_m(x, y), goal_m);
      if (std::isfinite(cost)) {
        queue_.push(
            {cost + bound_from_start(number(x, y)), cost, number(x, y), number(x, y), true});
      }
    }
  }
}

double CostToGo::at(const Vec2& at_m) {
  if (within_ != nullptr && !within_->holds(at_m)) return infinite;
  const Vec2 cells = (at_m - map_.low_m()) / map_.spacing_m();
  const int column = static_cast<int>(std::floor(cells.x()));
  const int row = static_cast<int>(std::floor(cells.y()));
  const auto least = [&] {
    double cost = infinite;
    for (int x = column; x <= column + 1; ++x) {
      for (int y = row; y <= row + 1; ++y) {
        if (has(x, y)) cost = std::min(cost, cost_[static_cast<std::size_t>(number(x, y))]);
      }
    }
    return cost;
  };
  while (!std::isfinite(least()) && !queue_.empty() && queue_.top().total <= limit_) expand_next();
  const double found = least();
  was_limited_ = was_limited_ || (!std::isfinite(found) && !queue_.empty());
  return found;
}

void CostToGo::expand_next() {
  Candidate best = queue_.top();
  queue_.pop();
  if (is_closed(best.node)) return;
  if (best.is_known) {
    expand(best);
  } else {
    evaluate(best);
  }
}

double CostToGo::bound_from_start(std::int32_t node) {
  return costs_.least(octile_m(place(node) - start_m_), height_m(node) - start_height_m_);
}

void CostToGo::offer(std::int32_t node, const Candidate& to) {
  if (within_ != nullptr && !within_->holds(place(node))) return;
  const double rise_m = height_m(to.node) - height_m(node);
  if (std::isnan(rise_m)) return;
  const double cost = to.cost + costs_.least((place(to.node) - place(node)).norm(), rise_m);
  queue_.push({cost + bound_from_start(node), cost, node, to.node, false});
}

void CostToGo::evaluate(Candidate& candidate) {
  candidate.cost = cost_[static_cast<std::size_t>(candidate.to)] +
                   costs_.straight(place(candidate.node), place(candidate.to));
  if (!std::isfinite(candidate.cost)) return;
  candidate.total = candidate.cost + bound_from_start(candidate.node);
  candidate.is_known = true;
  queue_.push(candidate);
}

void CostToGo::expand(const Candidate& to) {
  cost_[static_cast<std::size_t>(to.node)] = to.cost;
  const int column = to.node % map_.columns(), row = to.node / map_.columns();
  for (int x = column - 1; x <= column + 1; ++x) {
    for (int y = row - 1; y <= row + 1; ++y) {
      if (has(x, y) && !is_closed(number(x, y))) offer(number(x, y), to);
    }
  }
}

}  // namespace lsos
