// Weight of a layer near its edges and holes, where a coarser one takes over.
#pragma once

#include <functional>
#include <memory>

#include "terrain/grid/height_grid.h"

namespace lsos {

// Weights 0..1 of the nodes of a tile; smooth in between.
struct WeightTile {
  explicit WeightTile(const TileKey& key) : nodes(key) {}
  HeightTile nodes;
  bool is_whole = true;  // weight 1 everywhere
  const TileKey& key() const { return nodes.key(); }
};

// Weights of 0 at cells without ground or beyond the extent, rising to 1 at `fade_cells` from them.
// `tile` returns the layer's tiles; the weights are a pure function of those.
WeightTile edge_weights(const TileKey& key, int fade_cells, const GridExtent& extent,
                        const std::function<std::shared_ptr<const HeightTile>(TileKey)>& tile);

// Uniform cubic B-spline over the nodes' weights: stays between 0 and 1, C2.
SurfaceHeight smooth_weight(const WeightTile& weights, const CellPoint& at);

}  // namespace lsos
