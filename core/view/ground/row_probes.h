// Looks at the ground for rows of nodes that are drawn, about as finely as the rows lie.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>

#include "terrain/ground.h"

namespace lsos {

// One a thread; results never depend on what was asked before.
class RowProbes {
 public:
  explicit RowProbes(const Ground& ground) : ground_(&ground) {}

  // From a row at that distance to the next.
  static double step_m(double distance_m) { return std::max(least_m, share * distance_m); }

  // For rows at that distance: as far as they are closest all of the ground; beyond, what is as
  // wide as from one row to the next: detail on nodes at most half as far apart. One for each
  // octave.
  Ground::Probe& at(double distance_m) {
    const double share_m = share * distance_m;
    const int octave = share_m < least_m ? 0 : 1 + std::ilogb(share_m / least_m);
    const auto found = probes_.find(octave);
    if (found != probes_.end()) return found->second;
    return probes_
        .emplace(octave, octave == 0
                             ? Ground::Probe(*ground_)
                             : Ground::Probe::rough(*ground_, std::ldexp(least_m, octave - 2)))
        .first->second;
  }

 private:
  static constexpr double least_m = 0.2, share = 0.004;

  const Ground* ground_;
  std::map<int, Ground::Probe> probes_;
};

}  // namespace lsos
