// A mesh of the ground that may stand between two places: those parts of a narrow strip along the
// line that joins them that come near the line.
#pragma once

#include "terrain/ground.h"
#include "view/gl/mesh.h"
#include "view/ground/row_probes.h"

namespace lsos {

// Use one per thread; results do not depend on earlier calls.
class SightGround {
 public:
  // `ground` must outlive it.
  explicit SightGround(const Ground& ground) : ground_(&ground), probes_(ground) {}

  // The mesh is relative to `from_S_m`, in site axes. The target lies within `half_m` of the line.
  // Row spacing is 0.4 % of the distance to the nearer end, at least 0.2 m, with detail as wide as
  // that. The mesh ends behind ground that stands above the whole width of the line.
  Mesh between(const Vec3& from_S_m, const Vec3& to_S_m, double half_m);

 private:
  class Strip;

  const Ground* ground_;
  RowProbes probes_;
};

}  // namespace lsos
