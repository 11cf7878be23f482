#include "study/distribution.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace lsos {

namespace {

double quantile_of(const Uniform& uniform, double share) {
  return uniform.from + (uniform.to - uniform.from) * share;
}

// P(x) = P(min) + share (P(max) - P(min)). Beyond the mean the tail's own probability is used, as
// P is 1 there but for its last digits.
double quantile_of(const Normal& normal, double share) {
  const boost::math::normal_distribution<double> standard;
  const double low = (normal.min - normal.mean) / normal.deviation,
               high = (normal.max - normal.mean) / normal.deviation;
  if (low > 0) {
    const double from = cdf(complement(standard, low)), to = cdf(complement(standard, high));
    const double above = from + share * (to - from);
    if (!(above > 0 && above < 1)) return normal.max;
    return normal.mean + normal.deviation * boost::math::quantile(complement(standard, above));
  }
  const double from = cdf(standard, low), to = cdf(standard, high);
  const double below = from + share * (to - from);
  if (!(below > 0 && below < 1)) return below > 0 ? normal.max : normal.min;
  return normal.mean + normal.deviation * boost::math::quantile(standard, below);
}

double quantile_of(const Triangular& triangular, double share) {
  const auto [min, mode, max] = triangular;
  const double rising = (mode - min) / (max - min);
  if (share < rising) return min + std::sqrt(share * (max - min) * (mode - min));
  return max - std::sqrt((1 - share) * (max - min) * (max - mode));
}

struct Bounds {
  double least, greatest;
};
Bounds bounds_of(const Uniform& uniform) { return {uniform.from, uniform.to}; }
Bounds bounds_of(const Normal& normal) { return {normal.min, normal.max}; }
Bounds bounds_of(const Triangular& triangular) { return {triangular.min, triangular.max}; }

Bounds bounds(const Distribution& distribution) {
  return std::visit([](const auto& each) { return bounds_of(each); }, distribution);
}

}  // namespace

double quantile(const Distribution& distribution, double share) {
  const double value =
      std::visit([&](const auto& each) { return quantile_of(each, share); }, distribution);
  return std::clamp(value, least(distribution), greatest(distribution));
}

double least(const Distribution& distribution) { return bounds(distribution).least; }
double greatest(const Distribution& distribution) { return bounds(distribution).greatest; }

}  // namespace lsos
