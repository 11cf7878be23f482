// A terrain near the Moon's south pole with craters of all sizes, for tests of ground and of views.
#pragma once

#include <numbers>

#include "terrain/spec/terrain_spec.h"

namespace lsos {

// About 85 degrees south: a bowl, a hill, and craters from `least_m` on.
inline TerrainSpec cratered_terrain(double least_m) {
  constexpr double deg = std::numbers::pi / 180;
  TerrainSpec spec;
  ReliefSurface relief;
  relief.lat_rad = -85 * deg;
  relief.landforms = {{"bowl", 0, -84.8 * deg, 8000, 1500, 300},
                      {"hill", 0.3, -84.4 * deg, 9000, 0, 1200}};
  spec.layers = {relief};
  spec.detail.emplace();
  spec.detail->craters.emplace();
  spec.detail->craters->age_gyr = 3.8;
  spec.detail->craters->diameter_min_m = least_m;
  spec.detail->craters->diameter_max_m = 3000;
  return spec;
}

}  // namespace lsos
