#include "view/exposure/disc_strips.h"

#include <cmath>
#include <numbers>

namespace lsos {

namespace {

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

// Strips of a disc of radius 1, with x in place of the azimuth.
std::array<DiscStrip, disc_strips_count> unit_strips() {
  std::array<DiscStrip, disc_strips_count> strips;
  for (int k = 0; k < disc_strips_count; ++k) {
    const double from = cut_at(static_cast<double>(k) / disc_strips_count);
    const double to = cut_at((k + 1.0) / disc_strips_count);
    strips[static_cast<std::size_t>(k)] = {
        (from + to) / 2, std::numbers::pi / disc_strips_count / (2 * (to - from))};
  }
  return strips;
}

}  // namespace

std::array<DiscStrip, disc_strips_count> disc_strips(double sun_rad, double disc_rad) {
  static const std::array<DiscStrip, disc_strips_count> unit = unit_strips();
  std::array<DiscStrip, disc_strips_count> strips = unit;
  for (DiscStrip& strip : strips) {
    strip.azimuth_rad *= disc_rad / std::max(0.05, std::cos(sun_rad));
    strip.half_rad *= disc_rad;
  }
  return strips;
}

}  // namespace lsos
