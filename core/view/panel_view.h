// How much of a panel the Sun sees: the panel drawn green as it is seen from there, everything
// else black in front of it, and the green pixels counted.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "view/gpu.h"
#include "view/mesh.h"

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

class PanelView {
 public:
  static constexpr int directions_max = 64;

  // `gpu` must outlive the view; same thread.
  explicit PanelView(const Gpu& gpu);
  ~PanelView();

  // Share 0..1 of the panel that is seen from each direction, which points from the panel to a
  // light infinitely far away: the picture is orthographic, stretched so that the panel fills it. 0
  // where the direction meets the panel's back. Of the occluders what lies on the dark side of the
  // panel's plane does not count, nor within a millimetre of it. At most directions_max.
  std::vector<double> visible_shares(const PanelFace& panel, const Mesh& occluders,
                                     std::span<const Vec3> directions);

 private:
  struct Pipeline;
  std::unique_ptr<Pipeline> pipeline_;
};

}  // namespace lsos
