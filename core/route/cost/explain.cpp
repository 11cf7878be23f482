#include "route/cost/explain.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/units.h"

namespace lsos {

namespace {

constexpr int directions = 16;

// Two different numbers with as many decimals as make them look different.
std::string with_distinct_digits(std::string_view text, double found, double allowed,
                                 int decimals) {
  constexpr int decimals_max = 3;
  const auto told = [&](double value) { return fmt::format("{:.{}f}", value, decimals); };
  while (told(found) == told(allowed) && decimals < decimals_max) ++decimals;
  return fmt::format(fmt::runtime(text), told(found), told(allowed));
}

}  // namespace

Stance best_stance(GroundMap& map, const StanceFinder& finder, const Vec2& at_m) {
  Stance best;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < directions; ++k) {
    const double yaw_rad = 2 * std::numbers::pi * k / directions;
    const Stance stance = finder.at(map, at_m, {std::cos(yaw_rad), std::sin(yaw_rad)});
    if (!stance.is_on_ground) continue;
    const Hazard found = hazard(stance, finder.cost());
    if (found == Hazard::none) return stance;
    // A climb that is too steep says little of a place: other hazards come first.
    const double now = limit_use(stance, finder.cost()) + (found == Hazard::climb ? 1e3 : 0);
    if (now >= least) continue;
    least = now;
    best = stance;
  }
  return best;
}

std::string describe(Hazard hazard, const Stance& stance, const DriveCost& cost) {
  const DriveLimits& limits = cost.limits;
  switch (hazard) {
    case Hazard::none:
      return "free";
    case Hazard::no_ground:
      return "where the terrain is not known";
    case Hazard::slope:
      return with_distinct_digits("on a slope of {} degrees, {} are allowed",
                                  degrees(stance.slope_rad), degrees(limits.slope_max_rad), 0);
    case Hazard::uneven:
      return with_distinct_digits("uneven by {} m at a wheel, {} are allowed", stance.unevenness_m,
                                  limits.unevenness_max_m, 2);
    case Hazard::clearance:
      return with_distinct_digits("with {} m under the chassis, {} are wanted", stance.clearance_m,
                                  limits.clearance_min_m, 2);
    case Hazard::climb: {
      const double climb_rad = climb_max_rad(cost.soils[static_cast<std::size_t>(stance.soil)]);
      if (climb_rad < 0) {
        return "on soil that its wheels do not drive on, not even on the level";
      }
      return with_distinct_digits("up a slope of {} degrees, its wheels climb {} on this soil",
                                  degrees(stance.slope_rad), degrees(climb_rad), 0);
    }
    case Hazard::slide:
      if (stance.pitch_rad < -std::abs(stance.bank_rad)) {
        return fmt::format("down a slope of {:.0f} degrees, where brakes do not hold it",
                           degrees(stance.slope_rad));
      }
      return fmt::format("across a slope of {:.0f} degrees, where it slides",
                         degrees(std::abs(stance.bank_rad)));
    case Hazard::avoided:
      return "where the rover was stuck";
  }
  return {};
}

std::string fault_at(GroundMap& map, const StanceFinder& finder, const Vec2& at_m) {
  const Stance stance = best_stance(map, finder, at_m);
  const Hazard found = hazard(stance, finder.cost());
  return found == Hazard::none ? "" : describe(found, stance, finder.cost());
}

std::string fault_to_stop_at(GroundMap& map, const StanceFinder& finder, const Vec2& at_m) {
  std::string fault = fault_at(map, finder, at_m);
  if (!fault.empty()) return fault;
  const Stance stance = best_stance(map, finder, at_m);
  if (can_stop(stance, finder.cost())) return "";
  const SoilDrive& soil = finder.cost().soils[static_cast<std::size_t>(stance.soil)];
  return with_distinct_digits("on a slope of {} degrees, its wheels climb {} on this soil",
                              degrees(stance.slope_rad), degrees(climb_max_rad(soil)), 0);
}

std::string fault_ahead(GroundMap& map, const StanceFinder& finder, const Vec2& at_m,
                        const Vec2& ahead) {
  const Stance stance = finder.at(map, at_m, ahead);
  const Hazard found = hazard(stance, finder.cost());
  return found == Hazard::none ? "" : describe(found, stance, finder.cost());
}

}  // namespace lsos
