// Exposure of the ground to the Sun: how much of its disc a place sees over the surrounding
// terrain, found by marching over the height field. Used for maps; panels are evaluated by
// rendering (panel_view.h).
#pragma once

#include <optional>

#include "view/ground/ground_end.h"
#include "view/ground/ground_probes.h"

namespace lsos {

struct GroundLight {
  double sun_fraction = 0;  // visible share of the disc, 0..1
  double incidence = 0;  // cosine between the ground's normal and the disc's centre; negative: away
  // Present where part of the disc is seen over the end of the known ground: the true share may be
  // less.
  std::optional<GroundEnd> end;
};

// Use one per thread; results do not depend on earlier calls.
class GroundLightProbe {
 public:
  // `resolution_m`: resolution of the map; much smaller detail is left out.
  GroundLightProbe(const Ground& ground, double resolution_m);

  // `sun_S`: unit vector to the centre of the disc, whose angular radius is `disc_rad`. `height_m`:
  // height of the eye above the ground. Absent where there is no ground.
  std::optional<GroundLight> at(const Geodetic& place, const Vec3& sun_S, double disc_rad,
                                double height_m = 0);

 private:
  static constexpr double step_share = 0.01;    // of the distance marched
  static constexpr double coarse_share = 0.25;  // of a step: finer detail is left out

  struct Eye {
    Vec3 p_S_m, up_S;
    double height_m;         // above the reference surface
    double ground_height_m;  // of the last ground found along the ray
  };
  // Elevation angle of the horizon in a direction along the surface. Beyond its end the ground is
  // assumed to continue level. `matters_m`: distance up to which its end is searched for.
  double horizon_rad(Eye eye, const Vec3& along_S, double lowest_rad, double highest_rad,
                     double matters_m, GroundEndTracker& tracker);
  // Elevation angle at which the ground at that distance is seen.
  struct Elevation {
    double elevation_rad;
    bool is_known;
  };
  Elevation elevation(Eye& eye, const Vec3& along_S, double distance_m);
  Ground::Probe& probe(double distance_m) {
    return probes_.at(octave_above_m(resolution_m_, coarse_share * step_share * distance_m));
  }

  const Ground* ground_;
  double resolution_m_;
  GroundProbes probes_;
};

}  // namespace lsos
