#include "terrain/detail/poisson_field.h"

#include <algorithm>

namespace lsos {

// Knuth's method multiplies uniforms until they pass exp(-mean). The mean is taken in portions, so
// that the exponential does not underflow.
int poisson_count(double mean, RandomStream& random) {
  int count = 0;
  for (double rest = mean; rest > 0; rest -= 16) {
    const double limit = std::exp(-std::min(rest, 16.0));
    for (double product = random.uniform(); product > limit; product *= random.uniform()) ++count;
  }
  return count;
}

}  // namespace lsos
