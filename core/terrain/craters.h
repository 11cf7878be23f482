// Seeded bowl craters: where they are, and what they look like.
#pragma once

#include <cstdint>
#include <vector>

#include "terrain/site_plane.h"
#include "terrain/terrain_spec.h"

namespace lsos {

struct Crater {
  PlanePoint centre;
  double diameter_m = 0;  // rim crest to rim crest
};

// Height above the ground before the impact, at a distance from the centre: a parabolic bowl with
// a rounded rim, outside it an ejecta blanket that ends at `crater_reach` radii. C1.
double crater_height_m(double distance_m, double diameter_m, double depth_to_diameter);

inline constexpr double crater_reach = 3;  // crater radii

// All craters whose centre or blanket may touch the rectangle, in a fixed order. The field is a
// Poisson process: the same for the same seed, whichever rectangles are asked for.
std::vector<Crater> craters_touching(const CraterSurface& surface, std::uint64_t seed,
                                     const PlanePoint& low, const PlanePoint& high);

}  // namespace lsos
