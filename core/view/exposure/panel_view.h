// The visible share of a panel: the panel is drawn green as seen from a viewpoint, everything in
// front of it black, and the green pixels are counted. Used for panels that the Sun sees and for
// targets that another rover sees.
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

// The panel as an occluder of others: two triangles.
Mesh face_mesh(const PanelFace& face);

// Where a panel is seen from. At infinite distance the projection is orthographic.
struct Viewpoint {
  Vec3 direction = Vec3::UnitZ();  // unit, from the middle of the panel
  double distance_m = std::numeric_limits<double>::infinity();
};

// Occluders nearer than this to the panel's plane or to the viewer are ignored.
struct ViewMargins {
  double panel_m = 1e-3, viewer_m = 0;
};

class PanelView {
 public:
  static constexpr int directions_max = 64;

  // `gpu` must outlive the view; same thread.
  explicit PanelView(const Gpu& gpu);
  ~PanelView();

  // Share 0..1 of the panel that is seen from each viewpoint; 0 from behind the panel. The picture
  // is stretched so that the panel fills it. Occluders beyond the panel's plane or behind the
  // viewer are ignored. At most directions_max viewpoints.
  std::vector<double> visible_shares(const PanelFace& panel, const Mesh& occluders,
                                     std::span<const Viewpoint> viewpoints,
                                     const ViewMargins& margins = {});
  // The same from infinite distance; directions point from the panel to the viewer.
  std::vector<double> visible_shares(const PanelFace& panel, const Mesh& occluders,
                                     std::span<const Vec3> directions);

 private:
  struct Pipeline;
  std::unique_ptr<Pipeline> pipeline_;
};

}  // namespace lsos
