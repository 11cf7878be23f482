#include "view/ground/horizon_reach.h"

#include <algorithm>
#include <cmath>

#include "view/ground/highest_ground.h"

namespace lsos {

namespace {

constexpr double steepest_slope = 0.8390996;  // tangent of 40 degrees
constexpr double rise_length_m = 4000;

// Solves sqrt(L d) = d t + d^2/D for d. With s = sqrt(d), s is the only positive zero of
// s t + s^3/D - sqrt(L), which is convex there, so that Newton's steps from above never pass it.
double root_reach_m(double slope, double diameter_m) {
  const double rise = std::sqrt(rise_length_m);
  double s = std::cbrt(diameter_m * rise) + std::sqrt(std::max(0.0, -slope) * diameter_m);
  constexpr int steps = 40;
  for (int k = 0; k < steps; ++k) {
    const double value = s * slope + s * s * s / diameter_m - rise;
    const double next = s - value / (slope + 3 * s * s / diameter_m);
    if (!(next < s)) break;
    s = next;
  }
  return s * s;
}

}  // namespace

double greatest_rise_m(double distance_m) {
  return std::min(steepest_slope * distance_m, std::sqrt(rise_length_m * distance_m));
}

double horizon_reach_m(const Body& body, double eye_height_m, double elevation_rad) {
  constexpr double most_rad = 1.5;
  const double slope = std::tan(std::clamp(elevation_rad, -most_rad, most_rad));
  if (slope >= steepest_slope) return 0;
  const double diameter_m = 2 * body.equatorial_radius_m;
  const double over_eye_m = body.highest_ground_m - eye_height_m;
  // Each bound alone gives the distance at which its line or parabola meets that of the ray.
  const double root = slope * slope + 4 * over_eye_m / diameter_m;
  if (root < 0) return 0;
  const double highest_reach_m = diameter_m * (std::sqrt(root) - slope) / 2;
  const double steepest_reach_m = diameter_m * (steepest_slope - slope);
  return std::max(0.0,
                  std::min({highest_reach_m, steepest_reach_m, root_reach_m(slope, diameter_m)}));
}

}  // namespace lsos
