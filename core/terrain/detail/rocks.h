// Rocks: how many there are, and the shape that wheels roll over.
#pragma once

#include <cstdint>
#include <vector>

#include "terrain/detail/poisson_field.h"
#include "terrain/spec/terrain_spec.h"

namespace lsos {

struct Rock {
  PlanePoint centre;
  double diameter_m = 0;
  double height_m = 0;
};

// Share of the ground covered by rocks larger than D: cover * exp(-q D), q = 1.79 + 0.152/cover
// (Golombek and Rapp 1997, from the Viking and Mars Pathfinder landing sites; D in m).
double rock_cover(const RockPopulation& population, double diameter_m);
// Rocks per m2 that are larger than D and cover so much as discs, up to the population's largest.
double rocks_pm2(const RockPopulation& population, double diameter_m);

// Height of a rock at q = (distance / radius)^2 from its centre, as a share of its greatest height:
// a steep side and a flat top, C1. `by_q` is its derivative.
struct RockShape {
  double height;
  double by_q;
};
inline RockShape rock_shape(double q) {
  const double f = 1 - q * q;
  return {f * f, -4 * q * f};
}

// Integral of the rock's height over its disc, m3.
double rock_volume_m3(const Rock& rock);
// Expected volume of the rocks with a diameter in [low_m, high_m), m3 per m2.
double rock_volume_pm2(const RockPopulation& population, double low_m, double high_m);

// All rocks with a diameter in [diameter_low_m, diameter_high_m) that touch the rectangle, in a
// fixed order.
std::vector<Rock> rocks_touching(const RockPopulation& population, std::uint64_t seed,
                                 const PlaneRectangle& area, double diameter_low_m = 0,
                                 double diameter_high_m = 1e9);

}  // namespace lsos
