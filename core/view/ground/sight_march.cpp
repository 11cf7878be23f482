#include "view/ground/sight_march.h"

#include <algorithm>
#include <limits>

#include "view/ground/highest_ground.h"

namespace lsos {

namespace {

constexpr double march_step_least_m = 0.1;
constexpr double step_share = 0.005;         // of the distance to the nearer end
constexpr double march_coarse_share = 0.25;  // of a step: finer detail is left out
// Steps are cut where the line is lower than a slope of 60 degrees rises within a step.
constexpr double low_steps = 1.75;
constexpr int cut = 4;

// Difference between samples of the same ground by different probes.
constexpr double rounding_m = 1e-3;

}  // namespace

bool SightLine::is_free() const { return clearance_m > -rounding_m; }

SightMarch::SightMarch(const Ground& ground) : ground_(&ground), probes_(ground) {}

double SightMarch::clearance_m(const Vec3& p_S_m, double step_m) {
  const double resolution_m =
      octave_above_m(march_coarse_share * march_step_least_m, march_coarse_share * step_m);
  const GroundSample sample = probes_.at(resolution_m).sample(p_S_m);
  if (sample.is_ground()) return sample.gap_m;
  const SiteFrame& site = ground_->site();
  const double above_lowest_m = site.height_m(p_S_m) - ground_bound_m(site.body());
  return above_lowest_m < 0 ? above_lowest_m : std::numeric_limits<double>::infinity();
}

double SightMarch::least_clearance_m(const Vec3& end_S_m, const Vec3& along_S, double half_m,
                                     double enough_m) {
  double least_m = std::numeric_limits<double>::infinity();
  double x_m = march_step_least_m / cut;
  while (x_m < half_m && least_m > enough_m) {
    const double step_m = std::max(march_step_least_m, step_share * x_m);
    const double here_m = clearance_m(end_S_m + x_m * along_S, step_m);
    least_m = std::min(least_m, here_m);
    x_m += here_m < low_steps * step_m ? step_m / cut : step_m;
  }
  if (least_m <= enough_m) return least_m;
  const double step_m = std::max(march_step_least_m, step_share * half_m);
  return std::min(least_m, clearance_m(end_S_m + half_m * along_S, step_m));
}

SightLine SightMarch::march(const Vec3& from_S_m, const Vec3& to_S_m, double enough_m) {
  const Vec3 line_m = to_S_m - from_S_m;
  const double half_m = line_m.norm() / 2;
  if (half_m == 0) return {clearance_m(from_S_m, march_step_least_m)};
  const Vec3 along_S = line_m / (2 * half_m);
  const double first_m = least_clearance_m(from_S_m, along_S, half_m, enough_m);
  if (first_m <= enough_m) return {first_m};
  return {std::min(first_m, least_clearance_m(to_S_m, -along_S, half_m, enough_m))};
}

SightLine SightMarch::between(const Vec3& from_S_m, const Vec3& to_S_m) {
  return march(from_S_m, to_S_m, -std::numeric_limits<double>::infinity());
}

bool SightMarch::sees(const Vec3& from_S_m, const Vec3& to_S_m) {
  return march(from_S_m, to_S_m, -rounding_m).is_free();
}

}  // namespace lsos
