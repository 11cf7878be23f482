// How much of the Sun panels see: what may stand in its way is gathered and drawn.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "planet/sunlight.h"
#include "terrain/ground.h"
#include "view/exposure/renderer.h"

namespace lsos {

// What is lit, and what stands about it: vectors about `eye_S_m`, site axes.
struct LitScene {
  Vec3 eye_S_m = Vec3::Zero();   // near all of the faces
  std::vector<PanelFace> faces;  // each may shade the others
  Mesh near;                     // solids that may shade them
};

// What it answers is a pure function of what it is asked.
class Light {
 public:
  static constexpr int disc_samples_count = 16;

  // Both must outlive it.
  Light(const Ground& ground, Renderer& renderer) : ground_(&ground), renderer_(&renderer) {}

  // Of each face, the share 0..1 that is seen from the Sun, averaged over its disc. Ground far and
  // near counts.
  std::vector<double> sun_fractions(const LitScene& scene, const Sunlight& light);

 private:
  const Ground* ground_;
  Renderer* renderer_;
};

}  // namespace lsos
