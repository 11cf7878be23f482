// Request to the route planner, and its result: plain values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/archive.h"
#include "base/footprint.h"
#include "base/vector.h"

namespace lsos {

// Quantity that planning minimises.
enum class RouteAim {
  energy,  // electrical energy of driving
  risk,    // length, each metre over the share of the nearest limit that is left, at least 0.05
};
constexpr RouteAim last_value(RouteAim) { return RouteAim::risk; }

// Disc of ground that a leg avoids.
struct AvoidedDisc {
  Vec3 center_S_m = Vec3::Zero();
  double radius_m = 0;

  bool operator==(const AvoidedDisc&) const = default;
  void archive(Archive& a) { LSOS_ARCHIVE(a, center_S_m, radius_m); }
};

// An object that stands on the ground, as a rectangle seen from above.
struct Obstacle {
  std::string id;
  Vec3 center_S_m = Vec3::Zero();
  Vec3 ahead_S = Vec3::UnitX();  // unit vector, horizontal there
  Vec2 half_m = Vec2::Zero();    // half sizes along `ahead_S` and across it

  bool operator==(const Obstacle&) const = default;
  void archive(Archive& a) { LSOS_ARCHIVE(a, id, center_S_m, ahead_S, half_m); }
};

// Objects that a leg goes round, and the footprint of the rover: reference point at the origin,
// heading along x.
struct Obstacles {
  std::vector<Obstacle> standing;
  Footprint rover_at_rest;

  // Without objects the rover's footprint does not matter to the leg and is left out of the key of
  // the cache (planned_legs.h).
  void archive(Archive& a) {
    if (standing.empty()) return;
    LSOS_ARCHIVE(a, standing, rover_at_rest.center_S_m, rover_at_rest.half_m);
  }
};

struct LegRequest {
  Vec3 start_S_m = Vec3::Zero(), goal_S_m = Vec3::Zero();
  RouteAim aim = RouteAim::energy;
  std::uint64_t seed = 0;
  // Heading of the rover at the start, clockwise from north. For a rover that turns on the spot it
  // matters only to the turn at the start, whose time and energy the result includes.
  double start_heading_rad = 0;
  // If true, the result includes the time and energy of setting off and of stopping at the end.
  bool starts_at_rest = false;
  std::vector<AvoidedDisc> avoided = {};
  Obstacles obstacles = {};

  void archive(Archive& a) {
    LSOS_ARCHIVE(a, start_S_m, goal_S_m, aim, seed, start_heading_rad, starts_at_rest, avoided,
                 obstacles);
  }
};

struct PlannedLeg {
  Path3 path_S_m;  // from start to goal, on the ground; empty when there is no route
  // Points of the path at which a rover that cannot turn on the spot changes between forwards and
  // backwards, ascending; 0 where it begins backwards.
  std::vector<std::size_t> gear_changes;
  double cost = 0;  // of the request's aim: J, or m for RouteAim::risk
  double length_m = 0, duration_s = 0, energy_j = 0, slope_max_rad = 0;
  Vec3 steepest_S_m = Vec3::Zero();
  double end_heading_rad = 0;         // of the rover, clockwise from north at the goal
  std::vector<std::string> messages;  // of the optimiser, for the user

  // Why there is no route to the goal ("the goal is on a slope of 31 degrees, 20 are allowed"), and
  // the reachable place that is nearest to it: the goal itself where none was looked for.
  std::string reason;
  Vec3 nearest_S_m = Vec3::Zero();

  bool is_found() const { return !path_S_m.empty(); }
  bool begins_backwards() const { return !gear_changes.empty() && gear_changes.front() == 0; }
  bool ends_backwards() const { return gear_changes.size() % 2 == 1; }
  // Whether it leads to a place near the goal in its stead.
  bool ends_short() const { return is_found() && !reason.empty(); }
  void archive(Archive& a) {
    LSOS_ARCHIVE(a, path_S_m, gear_changes, cost, length_m, duration_s, energy_j, slope_max_rad,
                 steepest_S_m, end_heading_rad, messages, reason, nearest_S_m);
  }
  // Whether the numbers are finite and the changes of gear are points of the path.
  bool is_sound() const;
};

}  // namespace lsos
