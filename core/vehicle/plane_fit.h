// The plane that lies best through points of the ground.
#pragma once

#include <vector>

#include "base/vector.h"

namespace lsos {

struct PlaneFit {
  Vec3 point;   // mean of the points
  Vec3 normal;  // unit, on the side of `up`
};

// Least squares of distances along `up` (unit). At least three points that are not in line.
PlaneFit fit_plane(const std::vector<Vec3>& points, const Vec3& up);

}  // namespace lsos
