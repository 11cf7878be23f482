// The ground that may stand between two places: of a narrow strip along the line that joins them,
// the parts that come near to it.
#pragma once

#include "terrain/ground.h"
#include "view/gl/mesh.h"
#include "view/ground/row_probes.h"

namespace lsos {

// One a thread; results never depend on what was asked before.
class SightGround {
 public:
  // `ground` must outlive it.
  explicit SightGround(const Ground& ground) : ground_(&ground), probes_(ground) {}

  // About `from_S_m`, in site axes. What is looked at lies within `half_m` of the line. Rows lie as
  // close as 0.4 % of the distance to the nearer end, or 0.2 m; detail is drawn that is as wide.
  // Behind ground that stands over all of the line nothing more is looked for.
  Mesh between(const Vec3& from_S_m, const Vec3& to_S_m, double half_m);

 private:
  class Strip;

  const Ground* ground_;
  RowProbes probes_;
};

}  // namespace lsos
