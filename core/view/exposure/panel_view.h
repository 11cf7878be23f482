// How much of a panel is seen from somewhere: the panel drawn green as it is seen from there,
// everything else black in front of it, and the green pixels counted. A panel that the Sun sees; an
// ornament that another rover sees.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "view/gl/gpu.h"
#include "view/gl/mesh.h"

namespace lsos {

// A flat rectangle. It is lit on the side that `half_u_m` x `half_v_m` points to.
struct PanelFace {
  Vec3 centre_m = Vec3::Zero();
  Vec3 half_u_m = Vec3::UnitX();
  Vec3 half_v_m = Vec3::UnitY();

  Vec3 normal() const { return half_u_m.cross(half_v_m).normalized(); }
  double area_m2() const { return 4 * half_u_m.cross(half_v_m).norm(); }
};

// It as what shades others: two triangles.
Mesh face_mesh(const PanelFace& face);

// Where it is looked at from: infinitely far away the picture is orthographic.
struct Viewpoint {
  Vec3 direction = Vec3::UnitZ();  // unit, from the middle of the panel
  double distance_m = std::numeric_limits<double>::infinity();
};

// What lies so near to the panel's plane or to the viewer does not count.
struct ViewMargins {
  double panel_m = 1e-3, viewer_m = 0;
};

class PanelView {
 public:
  static constexpr int directions_max = 64;

  // `gpu` must outlive the view; same thread.
  explicit PanelView(const Gpu& gpu);
  ~PanelView();

  // Share 0..1 of the panel that is seen from each viewpoint: the picture is stretched so that the
  // panel fills it. 0 from behind the panel. Of the occluders what lies beyond the panel's plane or
  // behind the viewer does not count. At most directions_max.
  std::vector<double> visible_shares(const PanelFace& panel, const Mesh& occluders,
                                     std::span<const Viewpoint> viewpoints,
                                     const ViewMargins& margins = {});
  // From infinitely far away, in directions that point from the panel to the viewer.
  std::vector<double> visible_shares(const PanelFace& panel, const Mesh& occluders,
                                     std::span<const Vec3> directions);

 private:
  struct Pipeline;
  std::unique_ptr<Pipeline> pipeline_;
};

}  // namespace lsos
