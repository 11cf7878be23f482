// Ground probes for rows of mesh nodes, at about the resolution of the row spacing.
#pragma once

#include <algorithm>

#include "view/ground/ground_probes.h"

namespace lsos {

// Use one per thread; results do not depend on earlier calls.
class RowProbes {
 public:
  explicit RowProbes(const Ground& ground) : probes_(ground, ProbeDetail::sparse) {}

  // Spacing of rows at that distance.
  static double step_m(double distance_m) { return std::max(least_m, share * distance_m); }

  // The probe for rows at that distance, one per octave. Where rows are closest it samples the
  // ground in full; beyond, detail as wide as the row spacing, on nodes at most half as far apart.
  Ground::Probe& at(double distance_m) {
    const double share_m = share * distance_m;
    return probes_.at(share_m < least_m ? 0 : octave_below_m(least_m, share_m) / 2);
  }

 private:
  static constexpr double least_m = 0.2, share = 0.004;

  GroundProbes probes_;
};

}  // namespace lsos
