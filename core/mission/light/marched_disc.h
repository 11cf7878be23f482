// How much of a disc in the sky stands above the ground, by one march to the horizon: for
// estimates.
#pragma once

#include "view/ground/horizon_march.h"

namespace lsos {

// Share 0..1 of a disc about a direction (unit) that is seen from `eye_S_m`, with the horizon taken
// as level across the disc. `march`: on the same ground.
double share_over_ground(const Ground& ground, HorizonMarch& march, const Vec3& eye_S_m,
                         const Vec3& direction_S, double disc_rad);

// Resolution of such a march, m: smaller things hide the disc for a short time only.
inline constexpr double marched_resolution_m = 4;

}  // namespace lsos
