// What lies on a straight leg that a rover drives as it is drawn: no ground, ground that is too
// steep, things that stand there.
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
  double beyond_rad = 0;  // of a slope: by how much it is beyond the rover
};

struct DrawnLegFindings {
  std::optional<DrawnFinding> no_ground;  // the first place without ground under a wheel
  std::optional<DrawnFinding> occupied;   // the first place that something stands on
  std::optional<DrawnFinding> steep;  // the worst of stretches of 1 m or more that are too steep
};

// Of a leg of 100 km at most; of a longer one nothing.
DrawnLegFindings look_along(const Ground& ground, const DriveCost& cost, const Obstacles& obstacles,
                            const Vec3& from_S_m, const Vec3& to_S_m);

// By how much a rover that heads along `ahead` (unit) and turns in no less than `radius_m` passes a
// place `offset_m` from it, at best: how deep the place lies inside its turning circle. Not above 0
// where it can drive there.
double missed_by_m(const Vec2& ahead, const Vec2& offset_m, double radius_m);

}  // namespace lsos
