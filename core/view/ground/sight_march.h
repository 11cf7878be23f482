// Whether ground stands between two points, by marching over the height field: true lines over the
// curved body. Shares nothing with what is drawn, so that each checks the other.
#pragma once

#include "view/ground/ground_probes.h"

namespace lsos {

struct SightLine {
  // The least height of the line above the ground, along the vertical; negative where ground stands
  // in the way, infinite over no ground. Near 0: an edge, which another method may see otherwise.
  double clearance_m = 0;
  bool is_free() const;
};

// One a thread; results never depend on what was asked before.
class SightMarch {
 public:
  explicit SightMarch(const Ground& ground);

  // Ground that is not known hides nothing: holes, beyond the edge, and more than 60 degrees of the
  // body away from the site. But a line that dips below any ground of the body is hidden. Full
  // detail near either end; of what is far from both, only what is not much smaller than a 500th of
  // the distance to the nearer.
  SightLine between(const Vec3& from_S_m, const Vec3& to_S_m);
  // The same answer sooner: a hidden line is left where it first meets ground.
  bool sees(const Vec3& from_S_m, const Vec3& to_S_m);

 private:
  // `enough_m`: lower ones are not looked for.
  SightLine march(const Vec3& from_S_m, const Vec3& to_S_m, double enough_m);
  // From an end as far as `half_m`.
  double least_clearance_m(const Vec3& end_S_m, const Vec3& along_S, double half_m,
                           double enough_m);
  double clearance_m(const Vec3& p_S_m, double step_m);

  const Ground* ground_;
  GroundProbes probes_;
};

}  // namespace lsos
