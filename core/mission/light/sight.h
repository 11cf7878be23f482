// Line of sight: a view from one antenna to another, in which an ornament is looked for; and the
// same to the disc of Earth.
#pragma once

#include "terrain/ground.h"
#include "view/exposure/renderer.h"
#include "view/ground/sight_ground.h"

namespace lsos {

// What it answers is a pure function of what it is asked. `solids`: what may stand between, about
// `from_S_m`, site axes; what lies within 0.3 m of an antenna is the antenna's own.
class Sight {
 public:
  // The ornament: a square that faces the viewer, its half side.
  static constexpr double ornament_half_m = 0.05;
  // So much of it must be seen: of one that lies on level ground half can be.
  static constexpr double seen_share = 0.25;
  static constexpr int disc_samples_count = 16;

  // Both must outlive it.
  Sight(const Ground& ground, Renderer& renderer)
      : site_(ground.site()), ground_(&ground), renderer_(&renderer), between_(ground) {}

  // Share 0..1 of the ornament at `to_S_m` that is seen from `from_S_m`.
  double ornament_share(const Vec3& from_S_m, const Vec3& to_S_m, const Mesh& solids);
  bool sees(const Vec3& from_S_m, const Vec3& to_S_m, const Mesh& solids) {
    return ornament_share(from_S_m, to_S_m, solids) >= seen_share;
  }

  struct Disc {
    bool is_centre_seen = false;
    double fraction = 0;  // of the disc
  };
  // Of a disc of that angular radius about a direction (unit), infinitely far away.
  Disc disc(const Vec3& from_S_m, const Vec3& direction_S, double disc_rad, const Mesh& solids);

 private:
  SiteFrame site_;
  const Ground* ground_;
  Renderer* renderer_;
  SightGround between_;
};

}  // namespace lsos
