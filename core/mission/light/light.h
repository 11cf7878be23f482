// Light on panels: share of the Sun that they see, past what may stand in between, and their views
// of sky and ground.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mission/light/diffuse_view_cache.h"
#include "mission/light/lit_scene.h"
#include "mission/light/marched_disc.h"
#include "planet/sunlight.h"
#include "terrain/ground.h"
#include "view/exposure/renderer.h"

namespace lsos {

// Shares 0..1 of faces that are seen from the Sun: as expected, least and greatest.
struct SunRange {
  std::vector<double> expected, low, high;
};

// Results are pure functions of the arguments.
class Light {
 public:
  static constexpr int disc_samples_count = 16;

  // Both must outlive it. `is_estimate`: the ground's horizon is marched to, once for all faces;
  // only what is near is drawn.
  Light(const Ground& ground, Renderer& renderer, bool is_estimate = false)
      : ground_(&ground), renderer_(&renderer), diffuse_views_(ground, renderer) {
    if (is_estimate) march_.emplace(ground, marched_resolution_m, ProbeDetail::sparse);
  }

  // Share 0..1 of each face that is seen from the Sun, averaged over its disc. Near and far ground
  // counts.
  std::vector<double> sun_fractions(const LitScene& scene, const Sunlight& light) {
    return sun_range(scene, light).expected;
  }
  // The same with what an estimate does not know of the horizon; else all three are equal.
  SunRange sun_range(const LitScene& scene, const Sunlight& light);
  DiffuseViewCache& diffuse_views() { return diffuse_views_; }

 private:
  const Ground* ground_;
  Renderer* renderer_;
  DiffuseViewCache diffuse_views_;
  std::optional<HorizonMarch> march_;
};

}  // namespace lsos
