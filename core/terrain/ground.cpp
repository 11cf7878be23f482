#include "terrain/ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "planet/vertical_cells.h"
#include "terrain/blend.h"
#include "terrain/grid/cell_sides.h"
#include "terrain/ground_layers.h"
#include "terrain/raster/raster_advice.h"
#include "terrain/spec/terrain_beyond.h"

namespace lsos {

struct Ground::Impl : GroundLayers {
  using GroundLayers::GroundLayers;

  // Whose layers these are, where not its own: they refer to its plane.
  std::shared_ptr<const Impl> owner;

  // The ground whose layers are shared; nullptr: none.
  static std::shared_ptr<Impl>& shared() {
    static std::shared_ptr<Impl> shared;
    return shared;
  }
};

Ground::Ground(const TerrainSpec& spec, const SiteFrame& site, std::uint64_t seed)
    : impl_(std::make_shared<Impl>(spec, site, seed)) {
  const std::shared_ptr<Impl>& shared = Impl::shared();
  if (!shared || impl_->has_rasters()) return;
  if (impl_->layers_key() != shared->layers_key()) return;
  impl_->layers = shared->layers;
  impl_->owner = shared;
}
Ground::~Ground() = default;

const SiteFrame& Ground::site() const { return impl_->plane.site(); }
bool Ground::has_end() const { return lsos::has_end(impl_->spec); }
bool Ground::reaches(const Vec3& p_S_m) const { return impl_->plane.projected(p_S_m).is_near; }
const std::vector<Soil>& Ground::soils() const { return impl_->soils.soils(); }

std::string Ground::hash() const {
  Sha256 hash;
  impl_->add_layers_to(hash);
  impl_->soils.add_to(hash);
  return hash.hex();
}

std::string Ground::stamp() const {
  Sha256 hash;
  hash.add(this->hash());
  for (const auto& layer : impl_->layers) layer->grid().add_change_to(hash);
  return hash.hex();
}

std::vector<std::string> Ground::changed_files() const {
  std::set<std::string> files;
  const auto add = [&](const std::vector<std::string>& changed) {
    files.insert(changed.begin(), changed.end());
  };
  for (const auto& layer : impl_->layers) add(layer->grid().changed_files());
  add(impl_->soils.changed_files());
  return {files.begin(), files.end()};
}

std::string Ground::slivers(const Geodetic& place) const {
  const std::optional<std::size_t> most = impl_->main_layer(place);
  if (!most) return "";
  const auto* raster = std::get_if<RasterSurface>(&impl_->spec.layers[*most]);
  if (raster == nullptr) return "";
  return sliver_text(*raster, impl_->layers[*most]->grid(), site().body(), place);
}

bool Ground::is_beyond(const Geodetic& place) const {
  const std::optional<std::size_t> most = impl_->main_layer(place);
  return !most || (impl_->spec.beyond && *most >= impl_->spec.beyond->first_layer);
}

std::string Ground::coarseness(const Geodetic& place) const {
  const std::optional<std::size_t> most = impl_->main_layer(place);
  if (!most || impl_->layers[*most]->has_detail()) return "";
  const auto* raster = std::get_if<RasterSurface>(&impl_->spec.layers[*most]);
  return raster == nullptr ? "" : coarse_text(*raster, impl_->layers[*most]->cell_m());
}

std::optional<double> Ground::elevation_m(const Geodetic& place, double resolution_m) const {
  const auto sample = blended(impl_->layers.size(), [&](std::size_t k) {
    Layer& layer = *impl_->layers[k];
    return Layer::Probe(layer, layer.level_of_detail(resolution_m)).sample(place);
  });
  return sample ? std::optional(sample->height_m) : std::nullopt;
}

bool Ground::has_shared_layers() const {
  return Impl::shared() && impl_->layers == Impl::shared()->layers;
}

bool Ground::share_layers() const {
  if (impl_->has_rasters()) return false;
  if (!has_shared_layers()) Impl::shared() = impl_;
  return true;
}

std::vector<Fault> Ground::advice() const { return impl_->advice(); }

struct Ground::Probe::Impl {
  Impl(Ground::Impl& of, double resolution_m, double detail_nodes, bool fades)
      : ground(of), is_full_resolution(resolution_m == 0), verticals(of.plane.site()) {
    for (const auto& layer : of.layers) {
      layers.emplace_back(*layer, layer->level_of_detail(resolution_m, detail_nodes, fades));
    }
  }
  // Samples at full resolution lie close together; coarse ones would fill a new cell each.
  ProjectedPoint projected(const Vec3& p_S_m) {
    return is_full_resolution ? ground.plane.projected(p_S_m, verticals.at(p_S_m))
                              : ground.plane.projected(p_S_m);
  }

  Ground::Impl& ground;
  bool is_full_resolution;
  VerticalCells verticals;
  std::vector<Layer::Probe> layers;
};

Ground::Probe::Probe(const Ground& ground, double resolution_m)
    : Probe(std::make_unique<Impl>(*ground.impl_, resolution_m, Layer::detail_nodes_shown, false)) {
}
Ground::Probe::Probe(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Ground::Probe Ground::Probe::with_sparse_detail(const Ground& ground, double resolution_m) {
  return Probe(std::make_unique<Impl>(*ground.impl_, resolution_m, 1, false));
}
Ground::Probe Ground::Probe::with_fading_detail(const Ground& ground, double resolution_m) {
  return Probe(
      std::make_unique<Impl>(*ground.impl_, resolution_m, Layer::detail_nodes_shown, true));
}
Ground::Probe::~Probe() = default;
Ground::Probe::Probe(Probe&&) noexcept = default;
Ground::Probe& Ground::Probe::operator=(Probe&&) noexcept = default;

GroundSample Ground::Probe::sample(const Vec3& p_S_m) {
  const Ground::Impl& ground = impl_->ground;
  const ProjectedPoint point = impl_->projected(p_S_m);
  if (!point.is_near) return {};
  const std::optional<LayerSample> surface = blended(
      impl_->layers.size(), [&](std::size_t k) { return impl_->layers[k].sample(point.at); });
  if (!surface) return {};

  GroundSample sample;
  sample.elevation_m = surface->height_m;
  sample.up_S = point.up_S;
  sample.gap_m = point.height_m - surface->height_m;
  sample.soil = surface->is_rock ? ground.soils.rock_index() : ground.soils.at(point.at);
  // The surface is where height(p) - surface(x, y) is 0; its normal is the gradient of that. The
  // gradients of x and y grow from the sampled point down to the surface.
  const double growth = point.radius_m / (point.radius_m - sample.gap_m);
  const Vec3 gradient_S = point.up_S - growth * (surface->height_by_xy.x() * point.grad_x_S +
                                                 surface->height_by_xy.y() * point.grad_y_S);
  sample.normal_S = gradient_S * (1 / std::sqrt(gradient_S.squaredNorm()));
  return sample;
}

std::optional<double> Ground::Probe::highest_m(std::span<const Vec3> corners_S_m) {
  std::vector<PlanePoint> corners;
  for (const Vec3& corner_S_m : corners_S_m) {
    const ProjectedPoint point = impl_->projected(corner_S_m);
    if (!point.is_near) return {};
    corners.push_back(point.at);
  }
  HighestGround highest;
  highest.is_whole = false;
  for (Layer::Probe& layer : impl_->layers) {
    const std::optional<LayerTop> top = layer.top(corners);
    if (!top) return {};
    highest.highest_m = std::max(highest.highest_m, top->ground.highest_m);
    highest.is_whole |= top->ground.is_whole;
    if (top->is_alone) break;
  }
  return highest.is_whole ? std::optional(highest.highest_m) : std::nullopt;
}

}  // namespace lsos
