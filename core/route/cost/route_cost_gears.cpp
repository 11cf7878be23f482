// What it costs to drive backwards.
#include <algorithm>

#include "driving/fillet.h"
#include "route/cost/route_cost.h"

namespace lsos {

RouteCost RouteCost::backing() const {
  RouteCost costs = *this;
  costs.is_backing_ = true;
  return costs;
}

RouteCost::CornerCost RouteCost::gear_change() const {
  const DriveCost& cost = finder_.cost();
  // On average wheels are steered from straight to the tightest arc.
  const double steering_s =
      steering_lag_s + 1 / (std::max(cost.turning_radius_min_m, 1e-3) * curvature_rate_1pms);
  const double duration_s = cost.stop_s + steering_s;
  return {cost.stop_j + cost.idle_w * duration_s, duration_s};
}

double RouteCost::gear_changes(std::size_t count) const {
  if (count == 0) return 0;
  const DriveCost& cost = finder_.cost();
  const double level_j = cost.soils.front().by_slope.empty() ? 0 : cost.level_jpm() * gear_change_m;
  const double on_level = aim_ == RouteAim::risk ? gear_change_m : level_j;
  return static_cast<double>(count) * (price(gear_change()) + on_level);
}

}  // namespace lsos
