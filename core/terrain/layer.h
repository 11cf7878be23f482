// One layer of ground: a grid of heights, the detail upon it, and how it fades at its edges.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "terrain/detail.h"
#include "terrain/edge_weight.h"
#include "terrain/height_grid.h"
#include "terrain/key_cache.h"
#include "terrain/patch_map.h"

namespace lsos {

// Ground of one layer at a point of the site plane, with gradients by its x and y.
struct LayerSample {
  double height_m = 0;
  Vec2 height_by_xy = Vec2::Zero();
  double weight = 0;  // of this layer against the coarser ones, 0..1
  Vec2 weight_by_xy = Vec2::Zero();
  bool is_rock = false;
};

// The last tile of each parity of keys: wheels on both sides of a border keep their own. Shared
// pointers: the ground may drop a piece while a probe still uses it.
template <class Tile>
class LastTiles {
 public:
  template <class Get>
  const Tile& get(const TileKey& key, const Get& get) {
    std::shared_ptr<const Tile>& kept = kept_[2 * (key.row & 1) + (key.column & 1)];
    if (!kept || kept->key() != key) kept = get(key);
    return *kept;
  }

 private:
  std::array<std::shared_ptr<const Tile>, 4> kept_;
};

class Layer {
 public:
  // `fades`: a coarser layer lies below.
  Layer(std::unique_ptr<HeightGrid> grid, bool fades);

  const HeightGrid& grid() const { return *grid_; }
  void add_detail(const Detail& detail, const Stereographic& map, const DetailSetting& setting,
                  std::uint64_t seed);

  // Of the surface at a place; nullopt where this layer has no ground. Without detail where the
  // resolution is coarser than the grid's cells.
  std::optional<LayerSample> at(const Geodetic& place, double resolution_m);

  class Probe {
   public:
    explicit Probe(Layer& layer) : layer_(&layer) {}
    std::optional<LayerSample> sample(const PlanePoint& at);

   private:
    const Patch& patch(const PlanePoint& at);
    Layer* layer_;
    std::array<std::shared_ptr<const Patch>, 4> patches_;
    const Patch* last_patch_ = nullptr;  // one of them
    LastTiles<HeightTile> tiles_;
    LastTiles<DetailTile> details_;
    LastTiles<WeightTile> weights_;
    friend class Layer;
    std::optional<LayerSample> at_grid(GridPoint at, bool has_detail = true);
  };

 private:
  std::shared_ptr<const HeightTile> tile(const TileKey& key);
  std::shared_ptr<const DetailTile> detail_tile(const TileKey& key);
  std::shared_ptr<const WeightTile> weight_tile(const TileKey& key);

  std::unique_ptr<HeightGrid> grid_;
  int fade_cells_ = 0;
  std::unique_ptr<DetailField> detail_;
  double cell_m_ = 0;  // of the grid; known when there is detail
  PatchMap patches_;
  KeyCache<TileKey, HeightTile> tiles_{2048};    // 36 kB each: up to 150 MB
  KeyCache<TileKey, DetailTile> details_{2048};  // as large
  KeyCache<TileKey, WeightTile> weights_{512};
};

}  // namespace lsos
