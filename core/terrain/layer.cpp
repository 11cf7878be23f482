#include "terrain/layer.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

// A layer hands over within so many of its cells, or a quarter of a small raster.
constexpr int fade_cells_max = 32;

int fade_cells(const GridExtent& extent) {
  const double across = std::min(extent.goes_around() ? 1e9 : extent.u_high - extent.u_low,
                                 extent.v_high - extent.v_low);
  return static_cast<int>(std::clamp(across / 4, 4.0, static_cast<double>(fade_cells_max)));
}

}  // namespace

Layer::Layer(std::unique_ptr<HeightGrid> grid, bool fades)
    : grid_(std::move(grid)),
      fade_cells_(fades ? fade_cells(grid_->extent()) : 0),
      patches_([this](const PatchKey& key) { return grid_->patch(key); }) {}

void Layer::add_detail(const Detail& detail, const Stereographic& map, const DetailSetting& setting,
                       std::uint64_t seed) {
  detail_ = std::make_unique<DetailField>(detail, *grid_, map, setting, seed);
  cell_m_ = setting.cell_m;
}

std::shared_ptr<const HeightTile> Layer::tile(const TileKey& key) {
  return tiles_.get(key, [this](const TileKey& wanted) { return grid_->tile(wanted); });
}

std::shared_ptr<const DetailTile> Layer::detail_tile(const TileKey& key) {
  return details_.get(key, [this](const TileKey& wanted) { return detail_->tile(wanted); });
}

std::shared_ptr<const WeightTile> Layer::weight_tile(const TileKey& key) {
  return weights_.get(key, [this](const TileKey& wanted) {
    return edge_weights(wanted, fade_cells_, grid_->extent(),
                        [this](const TileKey& of) { return tile(of); });
  });
}

std::optional<LayerSample> Layer::at(const Geodetic& place, double resolution_m) {
  const auto at = grid_->coordinates(place);
  if (!at) return {};
  return Probe(*this).at_grid({at->u, at->v}, resolution_m < cell_m_);
}

// Patches that are not split any further never overlap, so that the one last used answers for
// every point it holds.
const Patch& Layer::Probe::patch(const PlanePoint& at) {
  if (last_patch_ != nullptr && last_patch_->holds(at)) return *last_patch_;
  const PatchKey key = Patch::key_of(at, 0);
  std::shared_ptr<const Patch>& kept = patches_[2 * (key.row & 1) + (key.column & 1)];
  if (!kept || !kept->holds(at)) kept = layer_->patches_.patch(at);
  last_patch_ = kept.get();
  return *kept;
}

std::optional<LayerSample> Layer::Probe::sample(const PlanePoint& at) {
  const Patch& patch = this->patch(at);
  if (patch.is_good()) return at_grid(patch.at(at));
  if (const auto exact = layer_->grid_->exact(at)) return at_grid(*exact);
  return {};
}

std::optional<LayerSample> Layer::Probe::at_grid(GridPoint at, bool has_detail) {
  if (!layer_->grid_->extent().bring_inside(at.u, at.v)) return {};
  const CellPoint cell(at.u, at.v);
  const TileKey key = cell.tile();
  SurfaceHeight surface = surface_height(
      tiles_.get(key, [this](const TileKey& wanted) { return layer_->tile(wanted); }), cell);
  if (std::isnan(surface.height_m)) return {};

  LayerSample sample;
  if (const DetailField* detail = layer_->detail_.get(); detail != nullptr && has_detail) {
    const CellPoint fine(detail->fine(at.u), detail->fine(at.v));
    const DetailTile& tile = details_.get(
        fine.tile(), [this](const TileKey& wanted) { return layer_->detail_tile(wanted); });
    const SurfaceHeight relief = surface_height(tile.heights, fine);
    const SurfaceHeight rock = tile.rocks.at(fine);
    const double per_cell = detail->subdivision();
    surface.height_m += relief.height_m + rock.height_m;
    surface.by_u_m += per_cell * (relief.by_u_m + rock.by_u_m);
    surface.by_v_m += per_cell * (relief.by_v_m + rock.by_v_m);
    sample.is_rock = rock.height_m > 0;
  }
  const auto by_xy = [&at](const SurfaceHeight& s) {
    return Vec2(s.by_u_m * at.u_by_x + s.by_v_m * at.v_by_x,
                s.by_u_m * at.u_by_y + s.by_v_m * at.v_by_y);
  };
  sample.height_m = surface.height_m;
  sample.height_by_xy = by_xy(surface);
  sample.weight = 1;
  if (layer_->fade_cells_ > 0) {
    const WeightTile& weights =
        weights_.get(key, [this](const TileKey& wanted) { return layer_->weight_tile(wanted); });
    if (!weights.is_whole) {
      const SurfaceHeight weight = smooth_weight(weights, cell);
      sample.weight = weight.height_m;
      sample.weight_by_xy = by_xy(weight);
    }
  }
  return sample;
}

}  // namespace lsos
