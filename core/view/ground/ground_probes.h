// Ground probes that get coarser with distance, cached by octave of resolution.
#pragma once

#include <cmath>
#include <map>

#include "terrain/ground.h"

namespace lsos {

// Use one per thread; results do not depend on earlier calls.
class GroundProbes {
 public:
  // `finest_m`: the finest resolution that is ever used.
  GroundProbes(const Ground& ground, double finest_m) : ground_(&ground), finest_m_(finest_m) {}

  // The probe for that resolution, or up to twice as coarse: with one probe per octave, a few serve
  // all distances.
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
