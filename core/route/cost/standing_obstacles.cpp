#include "route/cost/standing_obstacles.h"

#include <fmt/format.h>

#include <numbers>

#include "route/cost/route_cost.h"

namespace lsos {

StandingObstacles::StandingObstacles(const Obstacles& obstacles, const MapFrame& frame)
    : obstacles_(obstacles) {
  for (const Obstacle& obstacle : obstacles.standing) {
    const Vec2 center_m = frame.at(obstacle.center_S_m);
    const Vec2 ahead = frame.at(obstacle.center_S_m + obstacle.ahead_S) - center_m;
    footprints_.push_back({center_m, ahead.normalized(), obstacle.half_m});
  }
}

std::string StandingObstacles::fault_at(const Vec2& at_m) const {
  constexpr int directions = 16;
  for (std::size_t i = 0; i < footprints_.size(); ++i) {
    bool is_free = false;
    for (int k = 0; k < directions && !is_free; ++k) {
      const double yaw_rad = 2 * std::numbers::pi * k / directions;
      const Footprint rover = moved(obstacles_.rover_at_rest, at_m, yaw_rad);
      is_free = gap_m(footprints_[i], rover) > RouteCost::clearance_m;
    }
    if (!is_free) return fmt::format("where '{}' stands", id(i));
  }
  return "";
}

std::optional<std::size_t> StandingObstacles::near(const Vec2& at_m, double clearance_m) const {
  const Footprint& rover = obstacles_.rover_at_rest;
  const double reach_m = rover.half_m.norm() + rover.center_S_m.norm() + clearance_m;
  for (std::size_t i = 0; i < footprints_.size(); ++i) {
    if (distance_m(footprints_[i], at_m) < reach_m) return i;
  }
  return {};
}

}  // namespace lsos
