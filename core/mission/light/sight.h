// Line of sight between antennas: the share of a small target at one antenna that is visible from
// the other; likewise the visible share of the disc of Earth.
#pragma once

#include "terrain/ground.h"
#include "view/exposure/renderer.h"
#include "view/ground/sight_ground.h"

namespace lsos {

// Results are pure functions of the arguments. `solids`: what may stand in between, relative to
// `from_S_m`, site axes; what lies within 0.3 m of an antenna belongs to the antenna.
class Sight {
 public:
  // Half side of the target, a square that faces the viewer.
  static constexpr double target_half_m = 0.05;
  // Share of the target that must be visible. At most half of a target on level ground is visible,
  // so a share above 0.5 is never met there.
  static constexpr double seen_share = 0.25;
  static constexpr int disc_samples_count = 16;

  // Both must outlive it.
  Sight(const Ground& ground, Renderer& renderer)
      : site_(ground.site()), ground_(&ground), renderer_(&renderer), between_(ground) {}

  // Share 0..1 of the target at `to_S_m` that is visible from `from_S_m`.
  double target_share(const Vec3& from_S_m, const Vec3& to_S_m, const Mesh& solids);
  bool sees(const Vec3& from_S_m, const Vec3& to_S_m, const Mesh& solids) {
    return target_share(from_S_m, to_S_m, solids) >= seen_share;
  }

  struct Disc {
    bool is_centre_seen = false;
    double fraction = 0;  // visible share of the disc, 0..1
  };
  // Visibility of a disc of angular radius `disc_rad` about `direction_S` (unit), infinitely far
  // away.
  Disc disc(const Vec3& from_S_m, const Vec3& direction_S, double disc_rad, const Mesh& solids);

 private:
  SiteFrame site_;
  const Ground* ground_;
  Renderer* renderer_;
  SightGround between_;
};

}  // namespace lsos
