#include "route/cost/leg_request.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

// Farther from the site than any ground.
constexpr double far_m = 1e8;

// Longer than any leg that is planned. The time for what is foreseen of a leg grows with its
// length.
constexpr double longest_m = 1e6;

bool is_place(const Vec3& p_S_m) { return p_S_m.cwiseAbs().maxCoeff() < far_m; }

double path_length_m(const Path3& path_S_m) {
  double sum_m = 0;
  for (std::size_t k = 1; k < path_S_m.size(); ++k) {
    sum_m += (path_S_m[k] - path_S_m[k - 1]).norm();
  }
  return sum_m;
}

}  // namespace

bool PlannedLeg::is_sound() const {
  const double numbers = cost + length_m + duration_s + energy_j + slope_max_rad + end_heading_rad;
  return std::isfinite(numbers) && length_m >= 0 && duration_s >= 0 && is_place(steepest_S_m) &&
         is_place(nearest_S_m) && std::ranges::all_of(path_S_m, is_place) &&
         path_length_m(path_S_m) <= longest_m && std::ranges::is_sorted(gear_changes) &&
         (gear_changes.empty() || gear_changes.back() < path_S_m.size());
}

}  // namespace lsos
