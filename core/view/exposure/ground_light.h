// Exposure of the ground to the Sun: how much of its disc a place sees over the surrounding
// terrain, found by marching over the height field. Used for maps; panels are evaluated by
// rendering (panel_view.h).
#pragma once

#include <optional>

#include "view/ground/horizon_march.h"

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
  GroundLightProbe(const Ground& ground, double resolution_m)
      : ground_(&ground), march_(ground, resolution_m) {}

  // `sun_S`: unit vector to the centre of the disc, whose angular radius is `disc_rad`. `height_m`:
  // height of the eye above the ground. Absent where there is no ground.
  std::optional<GroundLight> at(const Geodetic& place, const Vec3& sun_S, double disc_rad,
                                double height_m = 0);

 private:
  const Ground* ground_;
  HorizonMarch march_;
};

}  // namespace lsos
