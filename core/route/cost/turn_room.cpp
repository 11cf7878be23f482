#include "route/cost/turn_room.h"

#include <cmath>

namespace lsos {

namespace {

constexpr double step_rad = std::numbers::pi / 90;

}  // namespace

std::optional<std::size_t> TurnRoom::hindrance(double yaw_rad) const {
  const double turn_rad = std::remainder(yaw_rad - from_yaw_rad, 2 * std::numbers::pi);
  if (turn_rad > left_rad) return on_left;
  if (-turn_rad > right_rad) return on_right;
  return {};
}

TurnRoom turn_room(const Footprint& rover_at_rest, const Vec2& at_m, double yaw_rad,
                   const std::vector<Footprint>& standing) {
  TurnRoom room;
  room.from_yaw_rad = yaw_rad;
  const Footprint here = moved(rover_at_rest, at_m, yaw_rad);
  const double reach_m = rover_at_rest.half_m.norm() + rover_at_rest.center_S_m.norm();
  for (std::size_t i = 0; i < standing.size(); ++i) {
    if (distance_m(standing[i], at_m) > reach_m || overlap(standing[i], here)) continue;
    const auto free_rad = [&](double side, double most_rad) {
      for (double turn_rad = step_rad; turn_rad < most_rad; turn_rad += step_rad) {
        if (overlap(standing[i], moved(rover_at_rest, at_m, yaw_rad + side * turn_rad))) {
          return turn_rad - step_rad;
        }
      }
      return most_rad;
    };
    if (const double left_rad = free_rad(1, room.left_rad); left_rad < room.left_rad) {
      room.left_rad = left_rad;
      room.on_left = i;
    }
    if (const double right_rad = free_rad(-1, room.right_rad); right_rad < room.right_rad) {
      room.right_rad = right_rad;
      room.on_right = i;
    }
  }
  return room;
}

}  // namespace lsos
