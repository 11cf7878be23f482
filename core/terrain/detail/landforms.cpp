#include "terrain/detail/landforms.h"

#include <algorithm>
#include <cmath>

#include "terrain/detail/craters.h"

namespace lsos {

namespace {

// Floor as a share of the diameter: 0.19 D^1.25 km in complex craters (Pike 1980), which makes
// small ones bowls; two thirds at most, an assumption.
double floor_share(double diameter_m) {
  return std::min(0.19 * std::pow(diameter_m / 1000, 0.25), 0.66);
}

}  // namespace

double landform_height_m(const Landform& form, double r) {
  if (form.depth_m == 0) {
    if (r >= 1) return 0;
    const double f = 1 - r * r;
    return form.rim_height_m * f * f;
  }
  if (r >= 1) return crater_height_m(r, form.depth_m, form.rim_height_m);
  // The profile is a level floor, a wall that is a smooth step, and a level crest.
  const double floor = floor_share(form.diameter_m);
  if (r <= floor) return form.rim_height_m - form.depth_m;
  const double s = (r - floor) / (1 - floor);
  return form.rim_height_m - form.depth_m * (1 - s * s * (3 - 2 * s));
}

}  // namespace lsos
