#include "view/ground/horizon_march.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

constexpr int steps_refined = 8;     // per step on either side of the highest ground
constexpr double eye_lift_m = 1e-3;  // above the ground, so that rounding does not hide the eye

}  // namespace

HorizonMarch::HorizonMarch(const Ground& ground, double resolution_m, ProbeDetail detail)
    : ground_(&ground), resolution_m_(resolution_m), probes_(ground, detail) {}

GroundSample HorizonMarch::ground_at(const Geodetic& place) {
  return probe(0).sample(ground_->site().p_S_m({place.lon_rad, place.lat_rad, 0}));
}

std::optional<HorizonMarch::Eye> HorizonMarch::eye(const Geodetic& place, double height_m) {
  const SiteFrame& site = ground_->site();
  const GroundSample ground = ground_at(place);
  if (!ground.is_ground()) return {};
  const Vec3 p_S_m =
      site.p_S_m({place.lon_rad, place.lat_rad, ground.elevation_m + height_m + eye_lift_m});
  return Eye{p_S_m, site.up_S(p_S_m), site.height_m(p_S_m), ground.elevation_m};
}

HorizonMarch::Elevation HorizonMarch::elevation(const Eye& eye, double& last_height_m,
                                                const Vec3& along_S, double distance_m) {
  const Vec3 p_S_m = eye.p_S_m + distance_m * along_S;
  const GroundSample sample = probe(distance_m).sample(p_S_m);
  Vec3 to_m = p_S_m - eye.p_S_m;
  if (sample.is_ground()) {
    last_height_m = sample.elevation_m;
    to_m -= sample.gap_m * sample.up_S;
  } else {
    const Vertical vertical = ground_->site().vertical(p_S_m);
    to_m -= (vertical.height_m - last_height_m) * vertical.up_S;
  }
  return {std::atan2(to_m.dot(eye.up_S), to_m.dot(along_S)), sample.is_ground()};
}

HorizonPoint HorizonMarch::towards(const Eye& eye, const Vec3& along_S, double lowest_rad,
                                   double highest_rad, double matters_m) {
  const Body& body = ground_->site().body();
  double last_height_m = eye.ground_height_m;
  HorizonPoint horizon;
  GroundEndTracker tracker;
  for (double x_m = resolution_m_;; x_m += std::max(resolution_m_, step_share * x_m)) {
    const double drop_m = x_m * x_m / (2 * body.equatorial_radius_m);
    const double above_rad = std::max(lowest_rad, horizon.elevation_rad);
    if (x_m * std::tan(above_rad) + drop_m > body.highest_ground_m - eye.height_m) break;
    const auto [found_rad, is_known] = elevation(eye, last_height_m, along_S, x_m);
    if (x_m < matters_m && (is_known || ground_->reaches(eye.p_S_m + x_m * along_S))) {
      tracker.add(x_m, is_known);
    }
    if (found_rad <= horizon.elevation_rad) continue;
    horizon = {found_rad, x_m, is_known, {}};
    if (found_rad > highest_rad) break;
  }
  horizon.end_m = tracker.end_m();
  if (horizon.elevation_rad > highest_rad) return horizon;
  const double at_m = horizon.distance_m;
  const double step_m = std::max(resolution_m_, step_share * at_m);
  for (int k = -steps_refined + 1; k < steps_refined; ++k) {
    const double x_m = at_m + step_m * k / steps_refined;
    if (k == 0 || x_m <= 0) continue;
    const auto [found_rad, is_known] = elevation(eye, last_height_m, along_S, x_m);
    if (!is_known || found_rad <= horizon.elevation_rad) continue;
    horizon.elevation_rad = found_rad;
    horizon.distance_m = x_m;
    horizon.is_known = true;
  }
  return horizon;
}

}  // namespace lsos
