#include "mission/routes/follower_limits.h"

#include <algorithm>

#include "mission/routes/drive_cost_model.h"

namespace lsos {

namespace {

constexpr double lookahead_least_m = 0.6;  // least lookahead of the path follower, for small rovers

}  // namespace

FollowerLimits limits_of(const VehicleConfig& vehicle, double speed_mps, double gravity_mps2) {
  FollowerLimits limits;
  limits.speed_mps = std::min(speed_mps, vehicle.speed_max_mps);
  limits.level_speed_mps = std::max(limits.speed_mps, vehicle.cruise_speed_mps);
  limits.acceleration_mps2 = vehicle.acceleration_mps2;
  limits.gravity_mps2 = gravity_mps2;
  limits.can_turn_on_spot = vehicle.can_turn_on_spot;
  limits.radius_min_m = vehicle.turning_radius_min_m;
  limits.turn_rate_radps = turn_rate_radps(vehicle);
  limits.lookahead_min_m = std::max(lookahead_least_m, wheel_reach_m(vehicle));
  return limits;
}

}  // namespace lsos
