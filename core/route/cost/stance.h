// How a rover stands on the ground of a map, and what stands in its way.
#pragma once

#include <vector>

#include "route/cost/drive_cost.h"
#include "route/map/ground_map.h"

namespace lsos {

struct Stance {
  bool is_on_ground = false;  // all wheels have ground; the rest holds only then
  // Of the plane through the ground under the wheels: along the heading, up positive, and to the
  // left of it, up positive.
  double pitch_rad = 0, bank_rad = 0;
  double slope_rad = 0;     // of that plane, steepest
  double unevenness_m = 0;  // of the wheel farthest from the plane of the others
  double roughness_m = 0;   // mean over the wheels of their distance from the plane of all
  double clearance_m = 0;   // least, between underside and ground
  int soil = 0;             // in the middle
};

// What a rover would come to at a place.
enum class Hazard { none, no_ground, slope, uneven, clearance, climb, slide, avoided };

// Places of the wheels. Those nearer to each other than half a spacing of the map, as twins are,
// stand on the same ground of it: one support, in their middle.
std::vector<Vec2> supports_m(const std::vector<Vec2>& wheels_m, double map_spacing_m);

// Distance of a map's nodes that shows a rover's wheels what they will meet.
double map_spacing_m(const DriveCost& cost);

// Works out stances of one rover.
class StanceFinder {
 public:
  explicit StanceFinder(const DriveCost& cost);

  // `ahead`: unit. Not on ground where it would not be wholly on the map, or not with a margin of
  // as much as a rectangle about it that lies as the map does is wider.
  Stance at(GroundMap& map, const Vec2& at_m, const Vec2& ahead) const;
  const DriveCost& cost() const { return cost_; }
  // Of what at() looks at from the middle, at most.
  double reach_m() const { return middle_B_m_.norm() + half_B_m_.norm(); }
  // Far from all limits, by half of what each leaves, whatever the soil: known without asking for
  // its slips.
  bool is_calm(const Stance& stance) const {
    return stance.is_on_ground && stance.slope_rad < calm_rad_ &&
           stance.unevenness_m < calm_share * cost_.limits.unevenness_max_m &&
           stance.clearance_m >= calm_clearance_m_;
  }

  static constexpr double calm_share = 0.5;

 private:
  // Where it stands on a map: its middle, ahead and to its left, all in nodes.
  struct Footing {
    Vec2 at, ahead, left;
    Vec2 nodes(double x_m, double y_m) const { return at + x_m * ahead + y_m * left; }
    // Of the rectangle of columns and rows about one so far ahead and aside.
    Vec2 half(const Vec2& half_m) const {
      return half_m.x() * ahead.cwiseAbs() + half_m.y() * left.cwiseAbs();
    }
  };
  // Over each node under the chassis; `plane` as plane_by_height.
  double least_clearance_m(const GroundMap::Window& ground, const Footing& footing,
                           const Vec3& plane) const;

  DriveCost cost_;
  double calm_rad_, calm_clearance_m_;
  struct Support {
    Vec2 at_B_m;
    // What its height adds to the plane's height at the middle, to its rise ahead and to that to
    // the left.
    Vec3 plane_by_height;
    // By how much farther it is from the plane of the others than from that of all.
    double leverage = 1;
  };
  std::vector<Support> supports_;
  Vec2 underside_low_B_m_, underside_high_B_m_;  // the rectangle of the chassis
  double underside_m_;                           // over the plane
  Vec2 middle_B_m_, half_B_m_;                   // of the rectangle of chassis and wheels
};

// At a stance that drives ahead. A descent is held to the limit of slopes as a climb is; what its
// wheels climb matters only uphill.
Hazard hazard(const Stance& stance, const DriveCost& cost);
// The same with other limits.
Hazard hazard(const Stance& stance, const DriveCost& cost, const DriveLimits& limits);

// The steepest slope that it is planned to climb there: less than its wheels just pull up, for
// loads are never even.
double climbs_rad(const SoilDrive& soil);

// Whether it can stop there, whatever its direction, and set off again.
bool is_held(const Stance& stance, const DriveCost& cost);

// Share of the limit that it comes nearest to, 0..1; where there is no hazard.
double demand(const Stance& stance, const DriveCost& cost);

}  // namespace lsos
