// Line of sight between antennas: the share of a small target at one antenna that is visible from
// the other; likewise the visible share of the disc of Earth.
#pragma once

#include <string>
#include <vector>

#include "mission/light/marched_disc.h"
#include "terrain/ground.h"
#include "view/exposure/renderer.h"
#include "view/ground/sight_ground.h"

namespace lsos {

// A rover or asset as it stands in the way.
struct NamedMesh {
  std::string id;
  Mesh mesh;
};

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
      : site_(ground.site()),
        ground_(&ground),
        renderer_(&renderer),
        between_(ground),
        march_(ground, marched_resolution_m, ProbeDetail::sparse) {}

  struct Line {
    double share = 0;  // of the target at the far end that is visible, 0..1
    bool is_seen = false;
    std::string hidden_by;  // as of Disc
  };
  Line line(const Vec3& from_S_m, const Vec3& to_S_m, const std::vector<NamedMesh>& solids);

  struct Disc {
    bool is_centre_seen = false;
    double fraction = 0;  // visible share of the disc, 0..1
    // What hides the centre: "ground" where the ground alone would, else the ids of bodies of which
    // each alone would, in the order of `solids`, comma-separated; of all near when none would.
    std::string hidden_by;
  };
  // Visibility of a disc of angular radius `disc_rad` about `direction_S` (unit), infinitely far
  // away.
  Disc disc(const Vec3& from_S_m, const Vec3& direction_S, double disc_rad,
            const std::vector<NamedMesh>& solids);

  // The same for estimates: the horizon is marched to, and drawn is what stands near.
  Disc marched_disc(const Vec3& from_S_m, const Vec3& direction_S, double disc_rad,
                    const std::vector<NamedMesh>& solids);

 private:
  // Share of a target that is visible from a viewpoint.
  double share(const PanelFace& target, const Mesh& solids, const Viewpoint& viewer);

  SiteFrame site_;
  const Ground* ground_;
  Renderer* renderer_;
  SightGround between_;
  HorizonMarch march_;
};

}  // namespace lsos
