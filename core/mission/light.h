// How much of the Sun panels see: what may stand in its way is gathered and drawn.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "planet/sunlight.h"
#include "terrain/ground.h"
#include "view/gpu.h"
#include "view/panel_view.h"

namespace lsos {

// What is lit, and what stands about it: vectors about `eye_S_m`, site axes.
struct LitScene {
  Vec3 eye_S_m = Vec3::Zero();   // near all of the faces
  std::vector<PanelFace> faces;  // each may shade the others
  Mesh near;                     // solids that may shade them
};

// Owns the renderer: made, used and destroyed on one thread. What it answers is a pure function of
// what it is asked.
class Light {
 public:
  static constexpr int disc_samples_count = 16;

  // Throws InputError when nothing can draw: what to install.
  explicit Light(const Ground& ground, GpuChoice choice = GpuChoice::any);

  const std::string& renderer() const { return gpu_.name(); }

  // Of each face, the share 0..1 that is seen from the Sun, averaged over its disc. Ground far and
  // near counts.
  std::vector<double> sun_fractions(const LitScene& scene, const Sunlight& light);

 private:
  const Ground* ground_;
  Gpu gpu_;
  PanelView view_;
};

}  // namespace lsos
