// Ground probes for rows of mesh nodes, at about the resolution of the row spacing.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>

#include "terrain/ground.h"

namespace lsos {

// Use one per thread; results do not depend on earlier calls.
class RowProbes {
 public:
  explicit RowProbes(const Ground& ground) : ground_(&ground) {}

  // Spacing of rows at that distance.
  static double step_m(double distance_m) { return std::max(least_m, share * distance_m); }

  // The probe for rows at that distance, one per octave. Where rows are closest it samples the
  // ground in full; beyond, detail as wide as the row spacing, on nodes at most half as far apart.
  Ground::Probe& at(double distance_m) {
    const double share_m = share * distance_m;
    const int octave = share_m < least_m ? 0 : 1 + std::ilogb(share_m / least_m);
    const auto found = probes_.find(octave);
    if (found != probes_.end()) return found->second;
    return probes_
        .emplace(octave, octave == 0 ? Ground::Probe(*ground_)
                                     : Ground::Probe::with_sparse_detail(
                                           *ground_, std::ldexp(least_m, octave - 2)))
        .first->second;
  }

 private:
  static constexpr double least_m = 0.2, share = 0.004;

  const Ground* ground_;
  std::map<int, Ground::Probe> probes_;
};

}  // namespace lsos
