// The horizon of terrain around a place, found by marching over the height field.
#pragma once

#include <numbers>
#include <optional>

#include "view/ground/ground_end.h"
#include "view/ground/ground_probes.h"

namespace lsos {

// The highest ground in a direction, as seen from the eye.
struct HorizonPoint {
  double elevation_rad = -std::numbers::pi / 2;  // -pi/2 where no ground was looked at
  double distance_m = 0;
  bool is_known = false;        // false: there is no ground; it was assumed to continue level
  std::optional<double> end_m;  // distance to which the ground is known, where it ends too soon
};

// Use one per thread; results do not depend on earlier calls.
class HorizonMarch {
 public:
  // `resolution_m`: much smaller detail is left out; with ProbeDetail::sparse some at the
  // resolution itself, too. Steps are as long, or 1 % of the distance.
  HorizonMarch(const Ground& ground, double resolution_m, ProbeDetail detail = ProbeDetail::dense);

  struct Eye {
    Vec3 p_S_m, up_S;
    double height_m;         // above the reference surface
    double ground_height_m;  // of the ground under it
  };
  // `height_m`: above the ground. Absent where there is no ground.
  std::optional<Eye> eye(const Geodetic& place, double height_m);
  // The ground under a place, at the resolution.
  GroundSample ground_at(const Geodetic& place);

  // Marches along a direction of the surface (unit) until no ground of the body can stand higher
  // than what was found, or than `lowest_rad`; or until ground above `highest_rad` is found. Beyond
  // its end the ground is assumed to continue level. `matters_m`: distance up to which its end is
  // searched for.
  HorizonPoint towards(const Eye& eye, const Vec3& along_S, double lowest_rad, double highest_rad,
                       double matters_m);

 private:
  static constexpr double step_share = 0.01;    // of the distance marched
  static constexpr double coarse_share = 0.25;  // of a step: finer detail is left out

  // Elevation angle at which the ground at that distance is seen; `last_height_m` is that of the
  // last ground found along the ray.
  struct Elevation {
    double elevation_rad;
    bool is_known;
  };
  Elevation elevation(const Eye& eye, double& last_height_m, const Vec3& along_S,
                      double distance_m);
  Ground::Probe& probe(double distance_m) {
    return probes_.at(octave_above_m(resolution_m_, coarse_share * step_share * distance_m));
  }

  const Ground* ground_;
  double resolution_m_;
  GroundProbes probes_;
};

}  // namespace lsos
