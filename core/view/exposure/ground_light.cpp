#include "view/exposure/ground_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "view/ground/highest_ground.h"
#include "view/ground/horizon_reach.h"

namespace lsos {

namespace {

// The disc is cut into vertical strips of equal area, and the horizon is taken as level across
// each. Five strips err by less than 1 % of the disc.
constexpr int strips = 5;

constexpr int steps_refined = 8;     // per step on either side of the highest ground
constexpr double eye_lift_m = 1e-3;  // above the ground, so that rounding does not hide the eye

// x of the vertical cut through a unit disc that leaves that share of its area to the left.
double cut_at(double share) {
  double low = -1, high = 1;
  for (int k = 0; k < 50; ++k) {
    const double x = (low + high) / 2;
    const double left = (std::asin(x) + x * std::sqrt(1 - x * x)) / std::numbers::pi + 0.5;
    (left < share ? low : high) = x;
  }
  return (low + high) / 2;
}

}  // namespace

GroundLightProbe::GroundLightProbe(const Ground& ground, double resolution_m)
    : ground_(&ground), resolution_m_(resolution_m), probes_(ground) {}

GroundLightProbe::Elevation GroundLightProbe::elevation(Eye& eye, const Vec3& along_S,
                                                        double distance_m) {
  const Vec3 p_S_m = eye.p_S_m + distance_m * along_S;
  const GroundSample sample = probe(distance_m).sample(p_S_m);
  Vec3 to_m = p_S_m - eye.p_S_m;
  if (sample.is_ground()) {
    eye.ground_height_m = sample.elevation_m;
    to_m -= sample.gap_m * sample.up_S;
  } else {
    const Vertical vertical = ground_->site().vertical(p_S_m);
    to_m -= (vertical.height_m - eye.ground_height_m) * vertical.up_S;
  }
  return {std::atan2(to_m.dot(eye.up_S), to_m.dot(along_S)), sample.is_ground()};
}

double GroundLightProbe::horizon_rad(Eye eye, const Vec3& along_S, double lowest_rad,
                                     double highest_rad, double matters_m,
                                     GroundEndTracker& tracker) {
  const Body& body = ground_->site().body();
  double highest = -std::numbers::pi / 2, at_m = 0;
  for (double x_m = resolution_m_;; x_m += std::max(resolution_m_, step_share * x_m)) {
    const double drop_m = x_m * x_m / (2 * body.equatorial_radius_m);
    if (x_m * std::tan(lowest_rad) + drop_m > body.highest_ground_m - eye.height_m) break;
    const auto [found, is_known] = elevation(eye, along_S, x_m);
    if (x_m < matters_m && (is_known || ground_->reaches(eye.p_S_m + x_m * along_S))) {
      tracker.add(x_m, is_known);
    }
    if (found <= highest) continue;
    highest = found;
    at_m = x_m;
    if (highest > highest_rad) return highest;
  }
  const double step_m = std::max(resolution_m_, step_share * at_m);
  for (int k = -steps_refined + 1; k < steps_refined; ++k) {
    const double x_m = at_m + step_m * k / steps_refined;
    if (k == 0 || x_m <= 0) continue;
    const auto [found, is_known] = elevation(eye, along_S, x_m);
    if (is_known) highest = std::max(highest, found);
  }
  return highest;
}

std::optional<GroundLight> GroundLightProbe::at(const Geodetic& place, const Vec3& sun_S,
                                                double disc_rad, double height_m) {
  const SiteFrame& site = ground_->site();
  const GroundSample ground = probe(0).sample(site.p_S_m({place.lon_rad, place.lat_rad, 0}));
  if (!ground.is_ground()) return {};
  const Vec3 eye_S_m =
      site.p_S_m({place.lon_rad, place.lat_rad, ground.elevation_m + height_m + eye_lift_m});
  const Vec3 up_S = site.up_S(eye_S_m);
  const Eye eye{eye_S_m, up_S, site.height_m(eye_S_m), ground.elevation_m};
  GroundLight light;
  light.incidence = ground.normal_S.dot(sun_S);
  const double sine = sun_S.dot(up_S);
  const Vec3 along_S = (sun_S - sine * up_S).normalized();
  const Vec3 across_S = up_S.cross(along_S);
  const double sun_rad = std::asin(std::clamp(sine, -1.0, 1.0));
  const double matters_m =
      ground_->has_end() ? horizon_reach_m(site.body(), eye.height_m, sun_rad - disc_rad) : 0;
  for (int k = 0; k < strips; ++k) {
    const double from = cut_at(static_cast<double>(k) / strips);
    const double to = cut_at((k + 1.0) / strips);
    const double middle = (from + to) / 2;
    // Half height of the rectangle that has the strip's width and area.
    const double half_rad = disc_rad * std::numbers::pi / strips / (2 * (to - from));
    const double aside_rad = disc_rad * middle / std::max(0.05, std::cos(sun_rad));
    const Vec3 ray_S = std::cos(aside_rad) * along_S + std::sin(aside_rad) * across_S;
    GroundEndTracker tracker;
    const double horizon =
        horizon_rad(eye, ray_S, sun_rad - half_rad, sun_rad + half_rad, matters_m, tracker);
    const double seen = std::clamp((sun_rad + half_rad - horizon) / (2 * half_rad), 0.0, 1.0);
    light.sun_fraction += seen / strips;
    const auto end_m = tracker.end_m();
    if (seen <= 0 || !end_m || (light.end && light.end->reaches_m <= *end_m)) continue;
    light.end = GroundEnd{*end_m, matters_m};
  }
  return light;
}

}  // namespace lsos
