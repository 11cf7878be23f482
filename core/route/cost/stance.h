// How a rover stands on the ground of a map, and what is a hazard to it there.
#pragma once

#include <vector>

#include "route/cost/drive_cost.h"
#include "route/map/ground_map.h"

namespace lsos {

struct Stance {
  bool is_on_ground = false;  // there is ground under all wheels; else the rest is not set
  // Inclination of the plane through the ground under the wheels: along the heading, up positive,
  // and to the left of it, up positive.
  double pitch_rad = 0, bank_rad = 0;
  double slope_rad = 0;     // steepest inclination of that plane
  double unevenness_m = 0;  // distance of the worst wheel from the plane of the others
  double roughness_m = 0;   // mean distance of the wheels from the plane of all
  double clearance_m = 0;   // least distance between underside and ground
  int soil = 0;             // at the reference point
};

// Reason why a rover may not be at a place.
enum class Hazard { none, no_ground, slope, uneven, clearance, climb, slide, avoided };

// Points on which the rover stands. Wheels nearer to each other than half the map's spacing, such
// as twin wheels, share one support at their mean position.
std::vector<Vec2> supports_m(const std::vector<Vec2>& wheels_m, double map_spacing_m);

// Spacing at which a map shows the ground that the rover's wheels meet, m.
double map_spacing_m(const DriveCost& cost);

// Computes stances of one rover.
class StanceFinder {
 public:
  explicit StanceFinder(const DriveCost& cost);

  // `ahead` is a unit vector. The stance is not on ground where the bounding box of the rover,
  // along the axes of the map, is not wholly on the map.
  Stance at(GroundMap& map, const Vec2& at_m, const Vec2& ahead) const;
  const DriveCost& cost() const { return cost_; }
  // Greatest distance from the reference point at which at() samples the ground.
  double reach_m() const { return middle_B_m_.norm() + half_B_m_.norm(); }
  // Whether the stance uses less than `far_share` of every limit on any soil: a fast test that
  // needs no slips.
  bool is_far_from_limits(const Stance& stance) const {
    return stance.is_on_ground && stance.slope_rad < far_slope_rad_ &&
           stance.unevenness_m < far_share * cost_.limits.unevenness_max_m &&
           stance.clearance_m >= far_clearance_m_;
  }

  static constexpr double far_share = 0.5;

 private:
  // Pose on a map: reference point, and vectors of 1 m ahead and to the left, all in nodes.
  struct Footing {
    Vec2 at, ahead, left;
    Vec2 nodes(double x_m, double y_m) const { return at + x_m * ahead + y_m * left; }
    // Half size, in columns and rows, of the bounding box of a rectangle with these half sizes.
    Vec2 half(const Vec2& half_m) const {
      return half_m.x() * ahead.cwiseAbs() + half_m.y() * left.cwiseAbs();
    }
  };
  // Least clearance over all nodes under the chassis; `plane` as in plane_by_height.
  double least_clearance_m(const GroundMap::Window& ground, const Footing& footing,
                           const Vec3& plane) const;

  DriveCost cost_;
  double far_slope_rad_, far_clearance_m_;
  struct Support {
    Vec2 at_B_m;
    // Contribution per metre of its height to the plane: height at the reference point, rise ahead,
    // rise to the left.
    Vec3 plane_by_height;
    // Ratio of its distance from the plane of the others to that from the plane of all.
    double leverage = 1;
  };
  std::vector<Support> supports_;
  Vec2 underside_low_B_m_, underside_high_B_m_;  // rectangle of the chassis
  double underside_m_;                           // above the plane of the wheels
  Vec2 middle_B_m_, half_B_m_;                   // rectangle of chassis and wheels
};

// Hazard of a stance while the rover drives ahead. A descent obeys the slope limit as a climb does;
// what the wheels climb matters uphill only.
Hazard hazard(const Stance& stance, const DriveCost& cost);
// The same with other limits.
Hazard hazard(const Stance& stance, const DriveCost& cost, const DriveLimits& limits);

// Steepest slope that planning lets the rover climb on this soil. It is less than what the wheels
// can just pull up, since loads are never even.
double climb_max_rad(const SoilDrive& soil);

// Whether the rover can stop there, whatever its heading, and set off again.
bool can_stop(const Stance& stance, const DriveCost& cost);

// Used share of the limit that the stance comes nearest to, 0..1 where there is no hazard.
double limit_use(const Stance& stance, const DriveCost& cost);

}  // namespace lsos
