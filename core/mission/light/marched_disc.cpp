#include "mission/light/marched_disc.h"

#include <algorithm>
#include <cmath>

#include "view/ground/disc_share.h"

namespace lsos {

DiscShare share_over_ground(const Ground& ground, HorizonMarch& march, const Vec3& eye_S_m,
                            const Vec3& direction_S, double disc_rad) {
  const Geodetic place = ground.site().geodetic(eye_S_m);
  const double ground_m = ground.elevation_m(place).value_or(place.height_m);
  const auto eye = march.eye(place, std::max(0.0, place.height_m - ground_m));
  if (!eye) return {};
  const double sine = std::clamp(direction_S.dot(eye->up_S), -1.0, 1.0);
  const Vec3 level_S = direction_S - sine * eye->up_S;
  if (level_S.norm() < 1e-6) {
    const double all = sine > 0 ? 1 : 0;
    return {all, all, all};
  }
  const double elevation_rad = std::asin(sine);
  const double reach_rad = disc_rad + horizon_doubt_rad;
  const HorizonPoint horizon = march.towards(*eye, level_S.normalized(), elevation_rad - reach_rad,
                                             elevation_rad + reach_rad, 0);
  const double above_rad = elevation_rad - horizon.elevation_rad;
  return {disc_share(above_rad / disc_rad), disc_share((above_rad - horizon_doubt_rad) / disc_rad),
          disc_share((above_rad + horizon_doubt_rad) / disc_rad)};
}

}  // namespace lsos
