// How far a rover that stands beside objects may turn on the spot.
#pragma once

#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include "base/footprint.h"

namespace lsos {

struct TurnRoom {
  double from_yaw_rad = 0;  // counter-clockwise from x
  // Angle to either side before the rover touches an object, 0..pi.
  double left_rad = std::numbers::pi, right_rad = std::numbers::pi;
  // Object that it would touch first on each side.
  std::optional<std::size_t> on_left, on_right;

  bool is_all_round() const { return !on_left && !on_right; }
  // Whether it may turn to a heading, by the smaller angle.
  bool allows(double yaw_rad) const { return !hindrance(yaw_rad); }
  // Object that blocks the turn to a heading.
  std::optional<std::size_t> hindrance(double yaw_rad) const;
};

// `rover_at_rest` has its reference point at the origin and heads along x. An object that it
// already touches blocks no turn, since the rover must be able to leave.
TurnRoom turn_room(const Footprint& rover_at_rest, const Vec2& at_m, double yaw_rad,
                   const std::vector<Footprint>& standing);

}  // namespace lsos
