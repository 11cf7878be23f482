// How much of a disc in the sky stands above the ground, by one march to the horizon: for
// estimates.
#pragma once

#include "view/ground/horizon_march.h"

namespace lsos {

// How far the horizon of such a march may be from that of the ground as it is drawn, rad. A tenth
// of a degree is a fifth of the Sun; by it estimates of sunlight along the horizon of the lunar
// south pole differed from what was simulated.
inline constexpr double horizon_doubt_rad = 0.1 * 3.14159265358979323846 / 180;

// Shares 0..1: as expected, and with the horizon higher or lower by `horizon_doubt_rad`.
struct DiscShare {
  double expected = 1, low = 1, high = 1;
};

// Share of a disc about a direction (unit) that is seen from `eye_S_m`, with the horizon taken as
// level across the disc. `march`: on the same ground.
DiscShare share_over_ground(const Ground& ground, HorizonMarch& march, const Vec3& eye_S_m,
                            const Vec3& direction_S, double disc_rad);

// Resolution of such a march, m: smaller things hide the disc for a short time only.
inline constexpr double marched_resolution_m = 4;

}  // namespace lsos
