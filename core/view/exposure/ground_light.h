// The Sun on the ground itself: how much of its disc a place sees over the terrain around it. By
// marching over the height field, for maps; panels are looked at by rendering (panel_view.h).
#pragma once

#include <optional>

#include "view/ground/ground_end.h"
#include "view/ground/ground_probes.h"

namespace lsos {

struct GroundLight {
  double sun_fraction = 0;  // of the disc, 0..1
  double incidence = 0;  // cosine between the ground's normal and the disc's middle; below 0: away
  // Some of the disc is seen over the end of the ground that is known: less of it may be.
  std::optional<GroundEnd> end;
};

// One a thread; results never depend on what was asked before.
class GroundLightProbe {
 public:
  // `resolution_m`: of the map that is made; what is much smaller is left out.
  GroundLightProbe(const Ground& ground, double resolution_m);

  // `sun_S`: unit, to the middle of the disc of that angular radius. Absent where there is no
  // ground. `height_m`: of the eye above it.
  std::optional<GroundLight> at(const Geodetic& place, const Vec3& sun_S, double disc_rad,
                                double height_m = 0);

 private:
  static constexpr double step_share = 0.01;    // of the distance marched
  static constexpr double coarse_share = 0.25;  // of a step: what is left out of the ground

  struct Eye {
    Vec3 p_S_m, up_S;
    double height_m;         // above the reference surface
    double ground_height_m;  // of the ground last found on the way from it
  };
  // The highest elevation of ground in a direction along the surface, rad. Beyond its end the
  // ground is taken to go on level. `matters_m`: where it ends is looked for so far.
  double horizon_rad(Eye eye, const Vec3& along_S, double lowest_rad, double highest_rad,
                     double matters_m, GroundEndTracker& tracker);
  // The elevation under which the ground at that distance is seen.
  struct Elevation {
    double elevation_rad;
    bool is_known;
  };
  Elevation elevation(Eye& eye, const Vec3& along_S, double distance_m);
  Ground::Probe& probe(double distance_m) {
    return probes_.at(coarse_share * step_share * distance_m);
  }

  const Ground* ground_;
  double resolution_m_;
  GroundProbes probes_;
};

}  // namespace lsos
