#include "route/cost/stretch.h"

#include <limits>
#include <utility>

namespace lsos {

namespace {

// Calls what(costs, line) for each stretch, with the costs of its gear.
template <class What>
void each(RouteCost& costs, const Stretches& stretches, const What& what) {
  for (const Stretch& stretch : stretches) {
    if (!stretch.is_backward) {
      what(costs, stretch.line);
      continue;
    }
    RouteCost backing = costs.backing();
    what(backing, stretch.line);
  }
}

// A route that begins backwards counts as a change of gear too.
std::size_t changes(const Stretches& stretches) {
  if (stretches.empty()) return 0;
  return stretches.size() - 1 + (stretches.front().is_backward ? 1 : 0);
}

}  // namespace

double driven(RouteCost& costs, const Stretches& stretches) {
  if (stretches.empty()) return std::numeric_limits<double>::infinity();
  double sum = costs.gear_changes(changes(stretches));
  each(costs, stretches, [&](RouteCost& of, const Line2& line) { sum += of.driven(line); });
  return sum;
}

LegSummary summary(RouteCost& costs, const Stretches& stretches) {
  LegSummary sum;
  each(costs, stretches, [&](RouteCost& of, const Line2& line) {
    const LegSummary part = of.of(line);
    if (part.slope_max_rad > sum.slope_max_rad) {
      sum.slope_max_rad = part.slope_max_rad;
      sum.steepest_m = part.steepest_m;
    }
    if (sum.hazard == Hazard::none) {
      sum.hazard = part.hazard;
      sum.hazard_m = part.hazard_m;
    }
    sum.cost += part.cost;
    sum.length_m += part.length_m;
    sum.duration_s += part.duration_s;
    sum.energy_j += part.energy_j;
  });
  sum.cost += costs.gear_changes(changes(stretches));
  const auto count = static_cast<double>(changes(stretches));
  const RouteCost::CornerCost change = costs.gear_change();
  sum.energy_j += count * change.energy_j;
  sum.duration_s += count * change.duration_s;
  return sum;
}

std::vector<Vec2> hazards(RouteCost& costs, const Stretches& stretches, double apart_m) {
  std::vector<Vec2> found;
  for (const Stretch& stretch : stretches) {
    const std::vector<Vec2> here = costs.hazards(stretch.line, apart_m);
    found.insert(found.end(), here.begin(), here.end());
  }
  return found;
}

}  // namespace lsos
