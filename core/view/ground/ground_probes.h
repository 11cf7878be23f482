// Ground probes by resolution, each made at its first use.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>

#include "terrain/ground.h"

namespace lsos {

// What a probe does with detail near its resolution, see Ground::Probe.
enum class ProbeDetail { dense, sparse, fading };

// Use one per thread; results do not depend on earlier calls.
class GroundProbes {
 public:
  // `ground` must outlive it.
  explicit GroundProbes(const Ground& ground, ProbeDetail detail = ProbeDetail::dense)
      : ground_(&ground), detail_(detail) {}

  // The probe for exactly that resolution; 0: full. Each resolution keeps tiles of its own, so
  // callers round theirs to octaves: a few probes then serve all distances.
  Ground::Probe& at(double resolution_m) {
    const auto found = probes_.find(resolution_m);
    if (found != probes_.end()) return found->second;
    return probes_.emplace(resolution_m, made(resolution_m)).first->second;
  }

 private:
  Ground::Probe made(double resolution_m) const {
    switch (detail_) {
      case ProbeDetail::sparse:
        return Ground::Probe::with_sparse_detail(*ground_, resolution_m);
      case ProbeDetail::fading:
        return Ground::Probe::with_fading_detail(*ground_, resolution_m);
      default:
        return Ground::Probe(*ground_, resolution_m);
    }
  }

  const Ground* ground_;
  ProbeDetail detail_;
  std::map<double, Ground::Probe> probes_;
};

// Greatest `finest_m` x 2^k, k >= 0, that does not exceed the length; `finest_m` for lesser ones.
inline double octave_below_m(double finest_m, double length_m) {
  return std::ldexp(finest_m, std::ilogb(std::max(1.0, length_m / finest_m)));
}

// Least `finest_m` x 2^k, k >= 0, that exceeds the length; `finest_m` up to that length itself.
inline double octave_above_m(double finest_m, double length_m) {
  if (length_m <= finest_m) return finest_m;
  return std::ldexp(finest_m, 1 + static_cast<int>(std::log2(length_m / finest_m)));
}

}  // namespace lsos
