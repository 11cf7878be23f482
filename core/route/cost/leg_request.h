// What is asked of the planner, and what it answers: plain values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/archive.h"
#include "base/footprint.h"
#include "base/vector.h"

namespace lsos {

// What a plan makes as small as can be.
enum class RouteAim {
  energy,  // electrical, of driving
  risk,    // metres, each divided by the share that is left of the limit it comes nearest to
};

// Ground about a place that a leg keeps off.
struct AvoidedDisc {
  Vec3 center_S_m = Vec3::Zero();
  double radius_m = 0;

  bool operator==(const AvoidedDisc&) const = default;
  void archive(Archive& a) { a(center_S_m)(radius_m); }
};

// A thing that stands on the ground, as a rectangle seen from above.
struct Obstacle {
  std::string id;
  Vec3 center_S_m = Vec3::Zero();
  Vec3 ahead_S = Vec3::UnitX();  // unit, horizontal there
  Vec2 half_m = Vec2::Zero();    // along `ahead_S` and across

  void archive(Archive& a) { a(id)(center_S_m)(ahead_S)(half_m); }
};

// What a leg goes round, and the ground that the rover covers: reference point at the origin,
// heading along x.
struct Obstacles {
  std::vector<Obstacle> standing;
  Footprint rover_at_rest;

  // Nothing where nothing stands, so that a leg's key then is what it is without.
  void archive(Archive& a) {
    if (standing.empty()) return;
    a(standing)(rover_at_rest.center_S_m)(rover_at_rest.half_m);
  }
};

struct LegRequest {
  Vec3 start_S_m = Vec3::Zero(), goal_S_m = Vec3::Zero();
  RouteAim aim = RouteAim::energy;
  std::uint64_t seed = 0;
  // Of the rover at the start, clockwise from north. The way of one that turns on the spot is the
  // same; what turning takes is told with it.
  double start_heading_rad = 0;
  // Then what setting off and stopping at the end of the drive take is told with it.
  bool starts_at_rest = false;
  std::vector<AvoidedDisc> avoided = {};
  Obstacles obstacles = {};

  void archive(Archive& a) {
    a(start_S_m)(goal_S_m)(aim)(seed)(start_heading_rad)(starts_at_rest)(avoided)(obstacles);
  }
};

struct PlannedLeg {
  Path3 path_S_m;  // from start to goal, on the ground; empty when there is none
  double cost = 0, length_m = 0, duration_s = 0, energy_j = 0, slope_max_rad = 0;
  Vec3 steepest_S_m = Vec3::Zero();
  double end_heading_rad = 0;  // clockwise from north at the goal
  std::vector<std::string> messages;

  // Why there is none ("the goal is too steep: 31 degrees"), and the place nearest to the goal that
  // can be reached.
  std::string reason;
  Vec3 nearest_S_m = Vec3::Zero();

  bool is_found() const { return !path_S_m.empty(); }
  void archive(Archive& a) {
    a(path_S_m)(cost)(
        length_m)(duration_s)(energy_j)(slope_max_rad)(steepest_S_m)(end_heading_rad)(messages)(reason)(nearest_S_m);
  }
};

}  // namespace lsos
