#include "view/exposure/ground_light.h"

#include <algorithm>
#include <cmath>

#include "view/exposure/disc_strips.h"
#include "view/ground/horizon_reach.h"

namespace lsos {

std::optional<GroundLight> GroundLightProbe::at(const Geodetic& place, const Vec3& sun_S,
                                                double disc_rad, double height_m) {
  const auto eye = march_.eye(place, height_m);
  if (!eye) return {};
  GroundLight light;
  light.incidence = march_.ground_at(place).normal_S.dot(sun_S);
  const double sine = sun_S.dot(eye->up_S);
  const Vec3 along_S = (sun_S - sine * eye->up_S).normalized();
  const Vec3 across_S = eye->up_S.cross(along_S);
  const double sun_rad = std::asin(std::clamp(sine, -1.0, 1.0));
  const double matters_m = ground_->has_end() ? horizon_reach_m(ground_->site().body(),
                                                                eye->height_m, sun_rad - disc_rad)
                                              : 0;
  for (const DiscStrip& strip : disc_strips(sun_rad, disc_rad)) {
    const Vec3 ray_S =
        std::cos(strip.azimuth_rad) * along_S + std::sin(strip.azimuth_rad) * across_S;
    const HorizonPoint horizon =
        march_.towards(*eye, ray_S, sun_rad - strip.half_rad, sun_rad + strip.half_rad, matters_m);
    const double seen = seen_share(strip, sun_rad, horizon.elevation_rad);
    light.sun_fraction += seen / disc_strips_count;
    if (seen <= 0 || !horizon.end_m) continue;
    if (light.end && light.end->reaches_m <= *horizon.end_m) continue;
    light.end = GroundEnd{*horizon.end_m, matters_m};
  }
  return light;
}

}  // namespace lsos
