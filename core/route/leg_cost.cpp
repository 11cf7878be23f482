#include "route/leg_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lsos {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Longest step of the midpoint rule, in spacings: a diagonal is one.
constexpr double step_spacings = 1.5;
// Nearer to a limit than this a metre of risk costs no more.
constexpr double share_left_min = 0.05;

// Calls what(stance, at, step) along a straight piece until it answers false.
template <class What>
bool walk(GroundMap& map, const StanceFinder& finder, const Vec2& from_m, const Vec2& to_m,
          const What& what) {
  const Vec2 way_m = to_m - from_m;
  const double length_m = way_m.norm();
  if (length_m < 1e-9) return true;
  const Vec2 ahead = way_m / length_m;
  const int steps =
      std::max(1, static_cast<int>(std::ceil(length_m / (step_spacings * map.spacing_m()))));
  for (int k = 0; k < steps; ++k) {
    const Vec2 at_m = from_m + way_m * ((k + 0.5) / steps);
    if (!what(finder.at(map, at_m, ahead), at_m, length_m / steps)) return false;
  }
  return true;
}

}  // namespace

LegCosts::LegCosts(GroundMap& map, const StanceFinder& finder, RouteAim aim)
    : map_(map), finder_(finder), aim_(aim) {
  find_least();
}

// Energy on slopes is that of the level and of lifting: E(slope) >= least + per_rise sin(slope). So
// much is certain to be needed for a leg of a length and a rise; with the climb's own share in it
// what is left for a metre is a good bound although going down costs next to nothing.
void LegCosts::find_least() {
  if (aim_ == RouteAim::risk) return;
  const auto least_with = [&](double per_rise) {
    double least = infinite;
    for (const SoilDrive& soil : finder_.cost().soils) {
      for (std::size_t k = 0; k < soil.by_slope.size(); ++k) {
        const double slope_rad = soil.first_rad + soil.step_rad * static_cast<double>(k);
        least = std::min(least, soil.by_slope[k].energy_jpm - per_rise * std::sin(slope_rad));
      }
    }
    return least;
  };
  least_per_metre_ = least_with(0);
  double most_jpm = 0;
  for (const SoilDrive& soil : finder_.cost().soils) {
    for (const SlopeDrive& drive : soil.by_slope) most_jpm = std::max(most_jpm, drive.energy_jpm);
  }
  constexpr int tries = 64;
  for (int k = 1; k <= tries; ++k) {
    const double per_rise = 4 * most_jpm * k / tries;
    const double least = least_with(per_rise);
    if (least <= least_per_metre_) continue;
    least_per_metre_ = least;
    per_rise_ = per_rise;
  }
  least_per_metre_ = std::max(0.0, least_per_metre_);
}

double LegCosts::rate(const Stance& stance) const {
  const DriveCost& cost = finder_.cost();
  if (aim_ == RouteAim::risk) return 1 / std::max(share_left_min, 1 - demand(stance, cost));
  return cost.soils[static_cast<std::size_t>(stance.soil)].at(stance.pitch_rad).energy_jpm;
}

double LegCosts::straight(const Vec2& from_m, const Vec2& to_m) {
  double sum = 0;
  const bool is_free =
      walk(map_, finder_, from_m, to_m, [&](const Stance& stance, const Vec2&, double step_m) {
        if (hazard(stance, finder_.cost()) != Hazard::none) return false;
        sum += rate(stance) * step_m / std::cos(stance.pitch_rad);
        return true;
      });
  return is_free ? sum : infinite;
}

bool LegCosts::can_stand(const Vec2& at_m, const Vec2& ahead) {
  return hazard(finder_.at(map_, at_m, ahead), finder_.cost()) == Hazard::none;
}

LegCost LegCosts::of(const Line2& line) {
  LegCost sum;
  const DriveCost& cost = finder_.cost();
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    walk(map_, finder_, line[k], line[k + 1],
         [&](const Stance& stance, const Vec2& at_m, double step_m) {
           sum.hazard = hazard(stance, cost);
           if (sum.hazard != Hazard::none) {
             sum.hazard_m = at_m;
             return false;
           }
           const SlopeDrive drive =
               cost.soils[static_cast<std::size_t>(stance.soil)].at(stance.pitch_rad);
           const double along_m = step_m / std::cos(stance.pitch_rad);
           sum.cost += rate(stance) * along_m;
           sum.length_m += along_m;
           sum.energy_j += drive.energy_jpm * along_m;
           sum.duration_s += along_m / drive.speed_mps;
           if (stance.slope_rad > sum.slope_max_rad) {
             sum.slope_max_rad = stance.slope_rad;
             sum.steepest_m = at_m;
           }
           return true;
         });
    if (sum.hazard == Hazard::none) continue;
    sum.cost = infinite;
    break;
  }
  return sum;
}

}  // namespace lsos
