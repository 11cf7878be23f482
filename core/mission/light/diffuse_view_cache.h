// Views of sky and ground that panels have, kept while nothing near them moves.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mission/light/lit_scene.h"
#include "terrain/ground.h"
#include "view/exposure/diffuse_view.h"
#include "view/exposure/renderer.h"

namespace lsos {

// Results are pure functions of the scene: what is kept only saves drawing it again. A parked rover
// is drawn once, one that drives at each look at the Sun, and the horizon is found again when it
// has left its cell of 4 m.
class DiffuseViewCache {
 public:
  // Both must outlive it.
  DiffuseViewCache(const Ground& ground, Renderer& renderer)
      : ground_(&ground), renderer_(&renderer) {}

  // Views of the first `count` faces. `id`: the rover or asset that they belong to.
  std::vector<DiffuseView> of(const std::string& id, const LitScene& scene, std::size_t count);

 private:
  // Where the horizon is seen from: the middle of a cell of the site frame, so high above ground.
  struct Cell {
    int x = 0, y = 0, height = 0;  // multiples of cell_m, cell_m and cell_height_m
    bool operator==(const Cell&) const = default;
  };
  struct Kept {
    std::vector<PanelFace> faces;
    Mesh near;
    std::vector<OpenShares> open;
    std::optional<Cell> cell;
    TerrainHorizon horizon;
  };

  static Cell cell_of(const Vec3& eye_S_m, const std::vector<PanelFace>& faces, const Vec3& up_S);
  TerrainHorizon horizon(const Cell& cell) const;
  std::vector<OpenShares> drawn(const LitScene& scene, std::size_t count);

  const Ground* ground_;
  Renderer* renderer_;
  std::map<std::string, Kept> kept_;
};

}  // namespace lsos
