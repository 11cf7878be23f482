#include "view/exposure/sun_disc.h"

#include <cmath>
#include <numbers>

namespace lsos {

namespace {

double brightness(double radius_share, LimbDarkening darkening) {
  if (darkening == LimbDarkening::none) return 1;
  const double rise = 1 - std::sqrt(1 - radius_share * radius_share);
  return 1 - 0.47 * rise - 0.23 * rise * rise;
}

}  // namespace

std::vector<DiscSample> disc_samples(const Vec3& direction, double radius_rad, int count,
                                     LimbDarkening darkening) {
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  const Vec3 across = direction.unitOrthogonal(), up = direction.cross(across);
  std::vector<DiscSample> samples;
  double sum = 0;
  for (int k = 0; k < count; ++k) {
    const double share = std::sqrt((k + 0.5) / count), angle = k * golden_angle;
    const double away = std::tan(radius_rad * share);
    const Vec3 aside = away * (std::cos(angle) * across + std::sin(angle) * up);
    samples.push_back({(direction + aside).normalized(), brightness(share, darkening)});
    sum += samples.back().weight;
  }
  for (DiscSample& sample : samples) sample.weight /= sum;
  return samples;
}

}  // namespace lsos
