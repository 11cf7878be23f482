// Craters and mountains at known places.
#pragma once

#include "terrain/spec/terrain_spec.h"

namespace lsos {

// Height above the ground around, r radii from the centre; zero from `crater_reach` radii on, for a
// mountain from one on. C1.
double landform_height_m(const Landform& landform, double r);

}  // namespace lsos
