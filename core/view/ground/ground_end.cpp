#include "view/ground/ground_end.h"

#include <algorithm>
#include <cmath>

#include "view/ground/horizon_reach.h"

namespace lsos {

namespace {

constexpr double end_step_least_m = 1, end_step_share = 0.02;  // of the distance
constexpr double full_up_to_m = 2;  // shorter steps sample the ground in full
constexpr double hole_steps = 3;    // shorter holes between two places are ignored
constexpr int halvings = 8;         // bisections of the step in which the ground ends

double step_m(double distance_m) { return std::max(end_step_least_m, end_step_share * distance_m); }

}  // namespace

GroundSample GroundEndProbe::sample(const Vec3& p_S_m, double step_m) {
  return probes_.at(step_m < full_up_to_m ? 0 : octave_below_m(1, step_m)).sample(p_S_m);
}

std::optional<GroundEnd> GroundEndProbe::towards(const Vec3& eye_S_m, const Vec3& direction_S,
                                                 double disc_rad) {
  if (!ground_->has_end()) return {};
  const SiteFrame& site = ground_->site();
  const Vec3 up_S = site.up_S(eye_S_m);
  const double sine = std::clamp(direction_S.dot(up_S), -1.0, 1.0);
  const Vec3 level_S = direction_S - sine * up_S;
  if (level_S.norm() < 1e-6) return {};
  const Vec3 along_S = level_S.normalized();
  const double elevation_rad = std::asin(sine);
  const double matters_m =
      horizon_reach_m(site.body(), site.height_m(eye_S_m), elevation_rad - disc_rad);
  const double top_slope = std::tan(elevation_rad + disc_rad);
  GroundEndTracker tracker;
  for (double x_m = end_step_least_m; x_m < matters_m; x_m += step_m(x_m)) {
    const Vec3 p_S_m = eye_S_m + x_m * along_S;
    const GroundSample found = sample(p_S_m, step_m(x_m));
    if (!found.is_ground() && !ground_->reaches(p_S_m)) break;
    tracker.add(x_m, found.is_ground());
    if (!found.is_ground()) continue;
    const Vec3 to_m = p_S_m - found.gap_m * found.up_S - eye_S_m;
    if (to_m.dot(up_S) > top_slope * to_m.dot(along_S)) return {};
  }
  const auto end_m = tracker.end_m();
  if (!end_m) return {};
  double low_m = *end_m, high_m = *end_m + step_m(*end_m);
  for (int k = 0; k < halvings; ++k) {
    const double middle_m = (low_m + high_m) / 2;
    (sample(eye_S_m + middle_m * along_S, 0).is_ground() ? low_m : high_m) = middle_m;
  }
  return GroundEnd{low_m, matters_m};
}

std::optional<GroundEnd> GroundEndProbe::between(const Vec3& from_S_m, const Vec3& to_S_m,
                                                 double margin_m) {
  if (!ground_->has_end()) return {};
  const SiteFrame& site = ground_->site();
  const Vec3 line_m = to_S_m - from_S_m;
  const double length_m = line_m.norm();
  if (length_m < end_step_least_m) return {};
  const Vec3 along_S = line_m / length_m;
  const auto ground_height_m = [&](const Vec3& end_S_m) {
    const GroundSample below = sample(end_S_m, 0);
    return below.is_ground() ? below.elevation_m : site.height_m(end_S_m);
  };
  const double from_m = ground_height_m(from_S_m), to_m = ground_height_m(to_S_m);
  // Horizontal share of the line's length.
  const double share = std::sqrt(std::max(0.0, 1 - std::pow(along_S.dot(site.up_S(from_S_m)), 2)));
  // Whether ground that rises from that under both ends may reach the line.
  const auto is_low = [&](double x_m) {
    const double highest_m = std::min(from_m + greatest_rise_m(share * x_m),
                                      to_m + greatest_rise_m(share * (length_m - x_m)));
    return site.height_m(from_S_m + x_m * along_S) < highest_m;
  };
  double last_ground_m = 0;
  for (double x_m = 0; x_m < length_m;) {
    const double near_m = std::min(x_m, length_m - x_m), step = step_m(near_m);
    const bool is_known =
        near_m < margin_m || sample(from_S_m + x_m * along_S, step).is_ground() || !is_low(x_m);
    if (is_known) last_ground_m = x_m;
    // Holes are measured in steps here, as one step may be a tenth of a short line.
    if (x_m - last_ground_m > hole_steps * step) return GroundEnd{last_ground_m, length_m};
    x_m += step;
  }
  return {};
}

}  // namespace lsos
