// One layer of ground: a grid of heights, the detail upon it, and how it fades at its edges.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "terrain/detail/detail.h"
#include "terrain/grid/edge_weight.h"
#include "terrain/grid/height_grid.h"
#include "terrain/grid/key_cache.h"
#include "terrain/grid/patch_map.h"
#include "terrain/grid/tile_top.h"

namespace lsos {

// Ground of one layer at a point of the site plane, with gradients by its x and y.
struct LayerSample {
  double height_m = 0;
  Vec2 height_by_xy = Vec2::Zero();
  double weight = 0;  // of this layer against the coarser ones, 0..1
  Vec2 weight_by_xy = Vec2::Zero();
  bool is_rock = false;
};

// Cache of the last tile of each parity of keys: wheels on both sides of a border keep their own.
// Tiles are shared pointers: the ground may drop one while a probe still uses it.
template <class Tile>
class TileCache {
 public:
  template <class Get>
  const Tile& get(const TileKey& key, const Get& get) {
    std::shared_ptr<const Tile>& cached = cached_[2 * (key.row & 1) + (key.column & 1)];
    if (!cached || cached->key() != key) cached = get(key);
    return *cached;
  }

 private:
  std::array<std::shared_ptr<const Tile>, 4> cached_;
};

// Upper bound on the ground of one layer in a region.
struct LayerTop {
  HighestGround ground;
  bool is_alone = false;  // no coarser layer takes over anywhere in it
};

// Position of a layer in the stack, whose layers take over from each other at edges and holes.
enum class LayerPlace { alone, above, last };

// Level of detail at which ground is sampled.
struct LevelOfDetail {
  int level = 0;  // level of the grid
  bool has_detail = true;
  int detail_level = 0;
};

class Layer {
 public:
  // Least width of fading, in cells; a layer that fades needs twice that across.
  static constexpr int fade_cells_min = 4;
  // Default number of detail nodes within the resolution: detail is rough on every scale.
  static constexpr double detail_nodes_shown = 16;

  // `cell_m`: mean side of the grid's cells; infinite where that is not known.
  Layer(std::unique_ptr<HeightGrid> grid, double cell_m, LayerPlace place);

  const HeightGrid& grid() const { return *grid_; }
  double cell_m() const { return cell_m_; }
  bool has_detail() const { return detail_ != nullptr; }
  void add_detail(const Detail& detail, const Stereographic& map, const DetailSetting& setting,
                  std::uint64_t seed);
  // Coarsest level of detail that still shows features as large as the resolution; 0: all there is.
  // Detail has `detail_nodes` nodes for a feature just large enough. Detail without features that
  // large is left out; with `fades`, only when they are smaller than two nodes.
  LevelOfDetail level_of_detail(double resolution_m, double detail_nodes = detail_nodes_shown,
                                bool fades = false) const;

  class Probe {
   public:
    explicit Probe(Layer& layer, const LevelOfDetail& level_of_detail)
        : layer_(&layer), level_of_detail_(level_of_detail) {}
    // Sample of the surface; nullopt where this layer has no ground.
    std::optional<LayerSample> sample(const PlanePoint& at);
    std::optional<LayerSample> sample(const Geodetic& place);
    // Upper bound on all samples in the convex region with these corners; nullopt where the region
    // is large or its place on the grid is not known.
    std::optional<LayerTop> top(std::span<const PlanePoint> corners);

   private:
    struct GridBox;
    std::optional<GridBox> box(std::span<const PlanePoint> corners);
    std::optional<GridPoint> grid_point(const PlanePoint& at);
    bool is_alone(const GridBox& box);
    double corner_bound_m(const GridBox& box, const Vec2& bend_m);
    const Patch& patch(const PlanePoint& at);
    std::optional<LayerSample> at_grid(GridPoint at);
    void add_detail(const GridPoint& at, SurfaceHeight& surface, LayerSample& sample);
    void set_weight(const TileKey& key, const CellPoint& cell, const GridPoint& at,
                    LayerSample& sample);
    Layer* layer_;
    LevelOfDetail level_of_detail_;
    std::array<std::shared_ptr<const Patch>, 4> patches_;
    const Patch* last_patch_ = nullptr;  // one of patches_
    TileCache<HeightTile> tiles_;
    TileCache<DetailTile> details_;
    TileCache<WeightTile> weights_;
    TileCache<TileTop> tops_, detail_tops_;
  };

 private:
  std::shared_ptr<const HeightTile> tile(const TileKey& key);
  std::shared_ptr<const DetailTile> detail_tile(const TileKey& key);
  std::shared_ptr<const WeightTile> weight_tile(const TileKey& key);
  std::shared_ptr<const TileTop> top(const TileKey& key);
  std::shared_ptr<const TileTop> detail_top(const TileKey& key);

  std::unique_ptr<HeightGrid> grid_;
  double cell_m_;
  bool fades_;
  double least_weight_;  // least weight
  std::unique_ptr<DetailField> detail_;
  PatchMap patches_;
  // A tile takes 36 kB, with dense rocks on wide cells some MB.
  KeyCache<TileKey, HeightTile> tiles_{megabytes(75)};
  KeyCache<TileKey, DetailTile> details_{megabytes(150)};
  KeyCache<TileKey, WeightTile> weights_{megabytes(20)};
  KeyCache<TileKey, TileTop> tops_{megabytes(4)}, detail_tops_{megabytes(8)};
};

}  // namespace lsos
