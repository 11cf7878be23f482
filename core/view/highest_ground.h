// How high ground may be: rays above it meet none.
#pragma once

#include "planet/body.h"

namespace lsos {

// The highest ground of the body above its reference surface, m.
inline double highest_ground_m(const Body& body) {
  if (body.name == "Moon") return 10800;
  if (body.name == "Mars") return 21300;
  return 8900;
}

}  // namespace lsos
