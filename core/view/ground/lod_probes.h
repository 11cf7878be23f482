// Ground samples at the level of detail requested, for pictures.
#pragma once

#include <cmath>

#include "view/ground/ground_probes.h"

namespace lsos {

// Use one per thread; results do not depend on earlier calls.
class LodProbes {
 public:
  explicit LodProbes(const Ground& ground) : probes_(ground, ProbeDetail::fading) {}

  // Samples at the octave below the resolution.
  GroundSample at_octave(const Vec3& p_S_m, double resolution_m) {
    return probe(std::floor(std::log2(resolution_m))).sample(p_S_m);
  }

  // Interpolates between the octaves below and above the resolution, so that detail that one of
  // them leaves out fades with the resolution instead of ending at an edge.
  GroundSample sample(const Vec3& p_S_m, double resolution_m) {
    const double exact = std::log2(resolution_m), octave = std::floor(exact);
    GroundSample fine = probe(octave).sample(p_S_m);
    const GroundSample coarse = probe(octave + 1).sample(p_S_m);
    if (!fine.is_ground() || !coarse.is_ground()) return fine;
    const double share = exact - octave;
    fine.gap_m = std::lerp(fine.gap_m, coarse.gap_m, share);
    fine.elevation_m = std::lerp(fine.elevation_m, coarse.elevation_m, share);
    fine.normal_S = (fine.normal_S + share * (coarse.normal_S - fine.normal_S)).normalized();
    return fine;
  }

 private:
  Ground::Probe& probe(double octave) {
    return probes_.at(std::ldexp(1.0, static_cast<int>(octave)));
  }

  GroundProbes probes_;
};

}  // namespace lsos
