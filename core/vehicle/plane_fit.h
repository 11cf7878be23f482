// The plane that fits points of the ground best.
#pragma once

#include <vector>

#include "base/vector.h"

namespace lsos {

struct PlaneFit {
  Vec3 point;   // mean of the points
  Vec3 normal;  // unit, on the side of `up`
};

// Least-squares fit of distances along `up` (unit). Needs three points or more, not on one line.
PlaneFit fit_plane(const std::vector<Vec3>& points, const Vec3& up);

}  // namespace lsos
