// Angles, directions and ground that several tests of views share.
#pragma once

#include <cmath>
#include <numbers>

#include "base/vector.h"
#include "terrain/spec/terrain_spec.h"

namespace lsos::test {

inline constexpr double deg = std::numbers::pi / 180;

inline Vec3 direction(double azimuth_rad, double elevation_rad) {
  return {std::cos(elevation_rad) * std::sin(azimuth_rad),
          std::cos(elevation_rad) * std::cos(azimuth_rad), std::sin(elevation_rad)};
}

// Near the Moon's south pole.
inline TerrainSpec bowl_and_hill() {
  TerrainSpec spec;
  ReliefSurface relief;
  relief.lat_rad = -85 * deg;
  relief.landforms = {{"bowl", 0, -84.97 * deg, 700, 90, 20},
                      {"hill", 0.03, -84.95 * deg, 1500, 0, 120}};
  spec.layers = {relief};
  return spec;
}

}  // namespace lsos::test
