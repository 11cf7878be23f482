// Sample directions over the disc of the Sun.
#pragma once

#include <vector>

#include "base/vector.h"

namespace lsos {

struct DiscSample {
  Vec3 direction = Vec3::UnitZ();  // unit
  double weight = 0;               // all weights sum to 1
};

enum class LimbDarkening { none, quadratic };

// `count` samples of a disc of that angular radius around a direction, each for an equal area, on a
// sunflower spiral (Vogel 1979). Quadratic limb darkening:
//   I = 1 - 0.47 (1 - m) - 0.23 (1 - m)^2
// with m the cosine at the Sun's surface, at about 550 nm (Allen 1973).
std::vector<DiscSample> disc_samples(const Vec3& direction, double radius_rad, int count,
                                     LimbDarkening darkening = LimbDarkening::none);

}  // namespace lsos
