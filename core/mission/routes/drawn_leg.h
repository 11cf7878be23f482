// Hazards on a straight leg that a rover drives as drawn: missing ground, ground that is too steep,
// obstacles.
#pragma once

#include <optional>
#include <string>

#include "route/cost/drive_cost.h"
#include "route/cost/leg_request.h"
#include "terrain/ground.h"

namespace lsos {

struct DrawnFinding {
  std::string what;    // "leads through 'Hab'"
  double along_m = 0;  // from the leg's start
  Vec3 p_S_m = Vec3::Zero();
  double beyond_rad = 0;  // slope in excess of the rover's limit
};

struct DrawnLegFindings {
  std::optional<DrawnFinding> no_ground;  // the first place without ground under a wheel
  std::optional<DrawnFinding> occupied;   // the first place at which an obstacle stands
  std::optional<DrawnFinding> steep;      // the worst stretch, of 1 m or more, that is too steep
};

// Examines a leg of at most 100 km; a longer one has no findings.
DrawnLegFindings examine_leg(const Ground& ground, const DriveCost& cost,
                             const Obstacles& obstacles, const Vec3& from_S_m, const Vec3& to_S_m);

// Least distance by which a rover that heads along `ahead` (unit) and turns in no less than
// `radius_m` misses a place `offset_m` from it: the depth of the place inside its turning circle.
// Not above 0 when it can drive there.
double miss_distance_m(const Vec2& ahead, const Vec2& offset_m, double radius_m);

}  // namespace lsos
