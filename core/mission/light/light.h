// Share of the Sun that panels see: what may stand in between is gathered and rendered.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "planet/sunlight.h"
#include "terrain/ground.h"
#include "view/exposure/renderer.h"

namespace lsos {

// Lit faces and the solids around them; vectors relative to `eye_S_m`, site axes.
struct LitScene {
  Vec3 eye_S_m = Vec3::Zero();   // near all of the faces
  std::vector<PanelFace> faces;  // each may shade the others
  Mesh near;                     // solids that may shade them
};

// Results are pure functions of the arguments.
class Light {
 public:
  static constexpr int disc_samples_count = 16;

  // Both must outlive it.
  Light(const Ground& ground, Renderer& renderer) : ground_(&ground), renderer_(&renderer) {}

  // Share 0..1 of each face that is seen from the Sun, averaged over its disc. Near and far ground
  // counts.
  std::vector<double> sun_fractions(const LitScene& scene, const Sunlight& light);

 private:
  const Ground* ground_;
  Renderer* renderer_;
};

}  // namespace lsos
