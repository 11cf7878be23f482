// Looks at the ground, each as coarse as it may be: a probe for each octave of resolution.
#pragma once

#include <cmath>
#include <map>

#include "terrain/ground.h"

namespace lsos {

// One a thread; results never depend on what was asked before.
class GroundLadder {
 public:
  explicit GroundLadder(const Ground& ground) : ground_(&ground) {}

  GroundSample sample(const Vec3& p_S_m, double resolution_m) {
    const int octave = static_cast<int>(std::floor(std::log2(resolution_m)));
    auto at = probes_.find(octave);
    if (at == probes_.end()) {
      at = probes_.emplace(octave, Ground::Probe(*ground_, std::ldexp(1.0, octave))).first;
    }
    return at->second.sample(p_S_m);
  }

 private:
  const Ground* ground_;
  std::map<int, Ground::Probe> probes_;
};

}  // namespace lsos
