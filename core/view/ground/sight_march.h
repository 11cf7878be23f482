// Lines of sight by marching over the height field: straight lines over the curved body. Shares
// nothing with the rendered method, so that each checks the other.
#pragma once

#include "view/ground/ground_probes.h"

namespace lsos {

struct SightLine {
  // Least vertical height of the line above the ground: negative where ground blocks it, infinite
  // where there is no ground. Near 0 the line grazes an edge, and another method may differ.
  double clearance_m = 0;
  bool is_free() const;
};

// Use one per thread; results do not depend on earlier calls.
class SightMarch {
 public:
  explicit SightMarch(const Ground& ground);

  // Unknown ground hides nothing: holes, ground beyond the edge, and ground more than 60 degrees of
  // the body away from the site. But a line that dips below all ground of the body is hidden.
  // Detail is full near either end; elsewhere detail much smaller than 1/500 of the distance to the
  // nearer end is left out.
  SightLine between(const Vec3& from_S_m, const Vec3& to_S_m);
  // The same result as between().is_free(), but faster: stops where the line first meets ground.
  bool sees(const Vec3& from_S_m, const Vec3& to_S_m);

 private:
  // `enough_m`: marching stops at a clearance this low.
  SightLine march(const Vec3& from_S_m, const Vec3& to_S_m, double enough_m);
  // Least clearance from one end to the distance `half_m`.
  double least_clearance_m(const Vec3& end_S_m, const Vec3& along_S, double half_m,
                           double enough_m);
  double clearance_m(const Vec3& p_S_m, double step_m);

  const Ground* ground_;
  GroundProbes probes_;
};

}  // namespace lsos
