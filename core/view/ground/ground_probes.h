// Looks at the ground that grow coarser with distance, kept for the next look.
#pragma once

#include <cmath>
#include <map>

#include "terrain/ground.h"

namespace lsos {

// One a thread; results never depend on what was asked before.
class GroundProbes {
 public:
  // Nothing is looked at more finely than that.
  GroundProbes(const Ground& ground, double finest_m) : ground_(&ground), finest_m_(finest_m) {}

  // For that resolution, or up to twice as coarse. By octaves: a few probes serve all distances.
  Ground::Probe& at(double wanted_m) {
    const int octave =
        wanted_m <= finest_m_ ? 0 : 1 + static_cast<int>(std::log2(wanted_m / finest_m_));
    const auto found = probes_.find(octave);
    if (found != probes_.end()) return found->second;
    return probes_.emplace(octave, Ground::Probe(*ground_, std::ldexp(finest_m_, octave)))
        .first->second;
  }

 private:
  const Ground* ground_;
  double finest_m_;
  std::map<int, Ground::Probe> probes_;
};

}  // namespace lsos
