#include "terrain/layer.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

// A layer fades over so many of its cells, or over a quarter of a small raster.
constexpr int fade_cells_max = 32;

// Least weight of a layer: where no other has ground, it continues to its very end.
constexpr double least_weight = 1e-9;
// Least weight of the last layer. It is larger, so that where a finer layer ends near the last
// one's end, the last one takes over within a few of the finer one's cells; at a hole of the last
// one it leaves a step of a thousandth of their difference.
constexpr double last_least_weight = 1e-3;

// A smaller last layer does not fade: it would be nothing but its edge.
constexpr double last_fading_cells_min = 16;

double cells_across(const GridExtent& extent) {
  return std::min(extent.goes_around() ? 1e9 : extent.u_high - extent.u_low,
                  extent.v_high - extent.v_low);
}

int fade_cells(const GridExtent& extent) {
  return static_cast<int>(
      std::clamp(cells_across(extent) / 4, double{Layer::fade_cells_min}, double{fade_cells_max}));
}

bool is_fading(const GridExtent& extent, LayerPlace place) {
  if (place == LayerPlace::alone) return false;
  const double across = cells_across(extent);
  return std::isfinite(across) && (place == LayerPlace::above || across >= last_fading_cells_min);
}

GridExtent extent_on(const GridExtent& extent, int level) {
  return {on_level(extent.u_low, level), on_level(extent.u_high, level),
          on_level(extent.v_low, level), on_level(extent.v_high, level),
          std::ldexp(extent.period, -level)};
}

// Coarsest level whose cells are not larger than the resolution.
int level_for(double resolution_m, double cell_m, int coarsest) {
  if (!(resolution_m > cell_m)) return 0;
  // A resolution of exactly so many cells is meant, whatever the last digits.
  return std::min(coarsest, static_cast<int>(std::log2(resolution_m / cell_m) + 0.01));
}

}  // namespace

Layer::Layer(std::unique_ptr<HeightGrid> grid, double cell_m, LayerPlace place)
    : grid_(std::move(grid)),
      cell_m_(cell_m),
      fades_(is_fading(grid_->extent(), place)),
      least_weight_(place == LayerPlace::last ? last_least_weight : least_weight),
      patches_([this](const PatchKey& key) { return grid_->patch(key); }) {}

void Layer::add_detail(const Detail& detail, const Stereographic& map, const DetailSetting& setting,
                       std::uint64_t seed) {
  detail_ = std::make_unique<DetailField>(detail, *grid_, map, setting, seed);
}

LevelOfDetail Layer::level_of_detail(double resolution_m, double detail_nodes, bool fades) const {
  LevelOfDetail level_of_detail;
  level_of_detail.level = level_for(resolution_m, cell_m_, grid_->coarsest_level());
  const double least_m = fades ? 2 * resolution_m / detail_nodes : resolution_m;
  level_of_detail.has_detail = detail_ != nullptr && least_m < detail_->largest_m();
  if (level_of_detail.has_detail) {
    level_of_detail.detail_level =
        level_for(resolution_m / detail_nodes, detail_->spacing_m(), DetailField::coarsest_level);
  }
  return level_of_detail;
}

std::shared_ptr<const HeightTile> Layer::tile(const TileKey& key) {
  return tiles_.get(key, [this](const TileKey& wanted) { return grid_->tile(wanted); });
}

std::shared_ptr<const DetailTile> Layer::detail_tile(const TileKey& key) {
  return details_.get(key, [this](const TileKey& wanted) { return detail_->tile(wanted); });
}

std::shared_ptr<const WeightTile> Layer::weight_tile(const TileKey& key) {
  return weights_.get(key, [this](const TileKey& wanted) {
    const int cells = std::max(fade_cells_min, fade_cells(grid_->extent()) >> wanted.level);
    return edge_weights(wanted, cells, extent_on(grid_->extent(), wanted.level),
                        [this](const TileKey& of) { return tile(of); });
  });
}

// Patches that are not split any further never overlap, so that the one last used is right for
// every point it holds.
const Patch& Layer::Probe::patch(const PlanePoint& at) {
  if (last_patch_ != nullptr && last_patch_->holds(at)) return *last_patch_;
  constexpr int cache_level = 3;  // 256 m: one slot for each square, whatever the patches' size
  const PatchKey key = Patch::key_of(at, cache_level);
  std::shared_ptr<const Patch>& cached = patches_[2 * (key.row & 1) + (key.column & 1)];
  if (!cached || !cached->holds(at)) cached = layer_->patches_.patch(at);
  last_patch_ = cached.get();
  return *cached;
}

std::optional<GridPoint> Layer::Probe::grid_point(const PlanePoint& at) {
  const Patch& patch = this->patch(at);
  return patch.is_good() ? std::optional(patch.at(at)) : layer_->grid_->exact(at);
}

std::optional<LayerSample> Layer::Probe::sample(const PlanePoint& at) {
  const std::optional<GridPoint> point = grid_point(at);
  return point ? at_grid(*point) : std::nullopt;
}

std::optional<LayerSample> Layer::Probe::sample(const Geodetic& place) {
  const auto at = layer_->grid_->coordinates(place);
  return at ? at_grid({at->u, at->v}) : std::nullopt;
}

namespace {

Vec2 gradient(const SurfaceHeight& s, const GridPoint& at) {
  return {s.by_u_m * at.u_by_x + s.by_v_m * at.v_by_x, s.by_u_m * at.u_by_y + s.by_v_m * at.v_by_y};
}

}  // namespace

std::optional<LayerSample> Layer::Probe::at_grid(GridPoint at) {
  if (!layer_->grid_->extent().bring_inside(at.u, at.v)) return {};
  const CellPoint cell(on_level(at.u, level_of_detail_.level),
                       on_level(at.v, level_of_detail_.level));
  TileKey key = cell.tile();
  key.level = level_of_detail_.level;
  SurfaceHeight surface = surface_height(
      tiles_.get(key, [this](const TileKey& wanted) { return layer_->tile(wanted); }), cell);
  if (std::isnan(surface.height_m)) return {};

  LayerSample sample;
  if (level_of_detail_.level > 0) {
    surface.by_u_m = std::ldexp(surface.by_u_m, -level_of_detail_.level);
    surface.by_v_m = std::ldexp(surface.by_v_m, -level_of_detail_.level);
  }
  if (level_of_detail_.has_detail && layer_->detail_ != nullptr) add_detail(at, surface, sample);
  sample.height_m = surface.height_m;
  sample.height_by_xy = gradient(surface, at);
  sample.weight = 1;
  if (layer_->fades_) set_weight(key, cell, at, sample);
  return sample;
}

void Layer::Probe::add_detail(const GridPoint& at, SurfaceHeight& surface, LayerSample& sample) {
  const DetailField& detail = *layer_->detail_;
  const double per_cell = std::ldexp(detail.subdivision(), -level_of_detail_.detail_level);
  const CellPoint fine((at.u + 0.5) * per_cell, (at.v + 0.5) * per_cell);
  TileKey key = fine.tile();
  key.level = level_of_detail_.detail_level;
  const DetailTile& tile =
      details_.get(key, [this](const TileKey& wanted) { return layer_->detail_tile(wanted); });
  const SurfaceHeight relief = surface_height(tile.heights, fine);
  const SurfaceHeight crater = tile.craters.at(fine);
  const SurfaceHeight rock = tile.rocks.at(fine);
  surface.height_m += relief.height_m + crater.height_m + rock.height_m;
  surface.by_u_m += per_cell * (relief.by_u_m + crater.by_u_m + rock.by_u_m);
  surface.by_v_m += per_cell * (relief.by_v_m + crater.by_v_m + rock.by_v_m);
  sample.is_rock = rock.height_m > 0;
}

void Layer::Probe::set_weight(const TileKey& key, const CellPoint& cell, const GridPoint& at,
                              LayerSample& sample) {
  const WeightTile& weights =
      weights_.get(key, [this](const TileKey& wanted) { return layer_->weight_tile(wanted); });
  if (weights.is_whole) return;
  const SurfaceHeight weight = smooth_weight(weights, cell);
  sample.weight = weight.height_m;
  sample.weight_by_xy = std::ldexp(1.0, -level_of_detail_.level) * gradient(weight, at);
  if (sample.weight < layer_->least_weight_) {
    sample.weight = layer_->least_weight_;
    sample.weight_by_xy = Vec2::Zero();
  }
}

}  // namespace lsos
