#include "view/exposure/terrain_horizon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "view/ground/ground_probes.h"

namespace lsos {

namespace {

constexpr double horizon_nearest_m = 2, horizon_farthest_m = 30e3, horizon_step_share = 0.1;
constexpr double detail_share = 0.5;  // resolution of the ground, of a step
constexpr double finest_m = detail_share * horizon_step_share * horizon_nearest_m;
constexpr double step_rad = 2 * std::numbers::pi / TerrainHorizon::azimuths;

}  // namespace

double TerrainHorizon::at(double azimuth_rad) const {
  const double steps = azimuth_rad / step_rad, below = std::floor(steps);
  const auto wrapped = [](int k) {
    return static_cast<std::size_t>(((k % azimuths) + azimuths) % azimuths);
  };
  const int k = static_cast<int>(below);
  return std::lerp(elevation_rad[wrapped(k)], elevation_rad[wrapped(k + 1)], steps - below);
}

TerrainHorizon terrain_horizon(const Ground& ground, const Vec3& eye_S_m) {
  const SiteFrame& site = ground.site();
  const Vertical eye = site.vertical(eye_S_m);
  const Vec3 north_S = site.north_S(eye_S_m), east_S = site.east_S(eye_S_m);
  const double over_eye_m = site.body().highest_ground_m - eye.height_m;
  GroundProbes probes(ground, ProbeDetail::sparse);
  TerrainHorizon horizon;
  for (int k = 0; k < TerrainHorizon::azimuths; ++k) {
    const Vec3 along_S = std::cos(k * step_rad) * north_S + std::sin(k * step_rad) * east_S;
    double slope = 0;  // the steepest found, at least level
    for (double x_m = horizon_nearest_m; x_m < horizon_farthest_m; x_m *= 1 + horizon_step_share) {
      if (x_m * slope > over_eye_m) break;
      const Vec3 p_S_m = eye_S_m + x_m * along_S;
      const GroundSample sample =
          probes.at(octave_below_m(finest_m, detail_share * horizon_step_share * x_m))
              .sample(p_S_m);
      if (!sample.is_ground()) continue;
      const Vec3 to_m = x_m * along_S - sample.gap_m * sample.up_S;
      const double ahead_m = to_m.dot(along_S);
      if (ahead_m > 0) slope = std::max(slope, to_m.dot(eye.up_S) / ahead_m);
    }
    horizon.elevation_rad[static_cast<std::size_t>(k)] = std::atan(slope);
  }
  return horizon;
}

}  // namespace lsos
