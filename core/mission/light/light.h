// Light on panels: share of the Sun that they see, past what may stand in between, and their views
// of sky and ground.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mission/light/diffuse_view_cache.h"
#include "mission/light/lit_scene.h"
#include "planet/sunlight.h"
#include "terrain/ground.h"
#include "view/exposure/renderer.h"

namespace lsos {

// Results are pure functions of the arguments.
class Light {
 public:
  static constexpr int disc_samples_count = 16;

  // Both must outlive it.
  Light(const Ground& ground, Renderer& renderer)
      : ground_(&ground), renderer_(&renderer), diffuse_views_(ground, renderer) {}

  // Share 0..1 of each face that is seen from the Sun, averaged over its disc. Near and far ground
  // counts.
  std::vector<double> sun_fractions(const LitScene& scene, const Sunlight& light);
  DiffuseViewCache& diffuse_views() { return diffuse_views_; }

 private:
  const Ground* ground_;
  Renderer* renderer_;
  DiffuseViewCache diffuse_views_;
};

}  // namespace lsos
