// How high the ground stands around a place, for what it hides of the sky.
#pragma once

#include <array>

#include "terrain/ground.h"

namespace lsos {

struct TerrainHorizon {
  static constexpr int azimuths = 32;
  // Elevation angle of the horizon, at least 0, in steps of azimuth clockwise from true north.
  std::array<double, azimuths> elevation_rad{};

  // Linear between the azimuths.
  double at(double azimuth_rad) const;
};

// The ground between 2 m and 30 km away, sampled at steps of 10 % of the distance with detail as
// coarse as that: the sky is an even light, of which a degree of horizon hides 0.03 % on level
// ground. Beyond its end the ground counts as level with the eye. A pure function of its arguments.
TerrainHorizon terrain_horizon(const Ground& ground, const Vec3& eye_S_m);

}  // namespace lsos
