#include "terrain/ground_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "terrain/grid/cell_sides.h"
#include "terrain/grid/grid_edge.h"
#include "terrain/spec/terrain_beyond.h"

namespace lsos {

namespace {

std::string text(const Detail& detail) {
  std::string text = fmt::format("\ndetail {}", detail.spacing_m);
  if (const auto& c = detail.craters) {
    text += fmt::format(" craters {} {} {} {} {} {} {}", c->diameter_min_m, c->diameter_max_m,
                        c->age_gyr.value_or(-1), c->exponent, c->density_pm2, c->depth_to_diameter,
                        c->degradation.value_or(-1));
  }
  if (const auto& r = detail.rocks) {
    text += fmt::format(" rocks {} {} {} {}", r->cover, r->diameter_min_m, r->diameter_max_m,
                        r->height_to_diameter);
  }
  if (const auto& r = detail.roughness) {
    text += fmt::format(" roughness {} {} {}", r->deviation_m, r->hurst, r->longest_m);
  }
  return text;
}

// Detail is drawn on a map about the middle of the finest layer, so that it stays in place when the
// site moves. A layer wider than local_rad has no such place: there the map is about the node of a
// net of longitudes and latitudes, net_rad apart, that is nearest to the site.
constexpr double local_rad = 0.35;
constexpr double net_rad = 5 * std::numbers::pi / 180;

// Beyond this the map of landforms would stretch them.
constexpr double relief_reach_rad = std::numbers::pi / 6;

void check_reach(const ReliefSurface& relief, const TerrainSpec& spec, const SiteFrame& site) {
  const Body& body = site.body();
  const Geodetic middle{relief.lon_rad, relief.lat_rad, 0};
  if (surface_distance_m(body, site.origin(), middle) <=
      relief_reach_rad * body.equatorial_radius_m) {
    return;
  }
  throw InputError(spec.place,
                   fmt::format("terrain {} has no ground at {:.4f},{:.4f}: it reaches 30 degrees "
                               "around {:.4f},{:.4f}",
                               spec.name, lon_deg(site.origin()), lat_deg(site.origin()),
                               lon_deg(middle), lat_deg(middle)));
}

std::unique_ptr<HeightGrid> make_grid(const Surface& surface, const TerrainSpec& spec,
                                      const SitePlane& plane, std::uint64_t seed) {
  if (const auto* raster = std::get_if<RasterSurface>(&surface)) {
    return make_raster_grid(*raster, spec.place, plane);
  }
  if (const auto* relief = std::get_if<ReliefSurface>(&surface)) {
    const auto craters = spec.detail ? spec.detail->craters : std::nullopt;
    check_reach(*relief, spec, plane.site());
    return make_relief_grid(*relief, craters, seed, plane);
  }
  return make_plane_grid(std::get<PlaneSurface>(surface), plane);
}

void check_room_to_fade(const GridExtent& extent, const TerrainSpec& spec) {
  const double columns = extent.u_high - extent.u_low, rows = extent.v_high - extent.v_low;
  constexpr double least = 2 * Layer::fade_cells_min;
  if (columns >= least && rows >= least) return;
  throw InputError(
      spec.place,
      fmt::format("terrain {}: a raster of {} x {} cells is too small to lie on coarser "
                  "layers; it fades at its edge: at least {} x {} are wanted",
                  spec.name, columns, rows, least, least));
}

Stereographic detail_map(const Surface& finest, const HeightGrid& grid, const SitePlane& plane) {
  const Body& body = plane.site().body();
  const Geodetic& site = plane.site().origin();
  if (const auto* relief = std::get_if<ReliefSurface>(&finest)) {
    return {body, relief->lon_rad, relief->lat_rad};
  }
  if (std::holds_alternative<PlaneSurface>(finest)) return {body, site.lon_rad, site.lat_rad};
  const GridExtent& extent = grid.extent();
  const auto middle = grid.place(centre(extent));
  const auto corner = grid.place({extent.u_low, extent.v_low});
  if (middle && corner && !extent.goes_around() &&
      surface_distance_m(body, *middle, *corner) < local_rad * body.equatorial_radius_m &&
      surface_distance_m(body, *middle, site) < 2 * local_rad * body.equatorial_radius_m) {
    return {body, middle->lon_rad, middle->lat_rad};
  }
  return {body, std::round(site.lon_rad / net_rad) * net_rad,
          std::round(site.lat_rad / net_rad) * net_rad};
}

DetailSetting setting_of(const Surface& surface, const CellSides& sides) {
  DetailSetting setting;
  setting.cell_m = sides.mean_m();
  setting.height_to_width = sides.along_column_m / sides.along_row_m;
  setting.is_over_raster = std::holds_alternative<RasterSurface>(surface);
  if (std::holds_alternative<ReliefSurface>(surface)) {
    setting.crater_max_m = relief_crater_min_cells * setting.cell_m;
  }
  return setting;
}

}  // namespace

GroundLayers::GroundLayers(const TerrainSpec& terrain, const SiteFrame& site,
                           std::uint64_t seed_of_plan)
    : spec(terrain), seed(seed_of_plan), plane(site), soils(spec, plane) {
  for (std::size_t k = 0; k < spec.layers.size(); ++k) {
    std::unique_ptr<HeightGrid> grid = make_grid(spec.layers[k], spec, plane, seed);
    if (place_of(k) == LayerPlace::above) check_room_to_fade(grid->extent(), spec);
    const double side_m = middle_sides(*grid).mean_m();
    layers.push_back(std::make_shared<Layer>(std::move(grid), side_m, place_of(k)));
  }
  if (spec.beyond) check_beyond();
  if (!spec.detail) return;
  const std::size_t first = first_with_detail();
  const Stereographic map = detail_map(spec.layers[first], layers[first]->grid(), plane);
  for (std::size_t k = first; k < layers.size(); ++k) {
    if (!(layers[k]->cell_m() <= detail_cell_max_m)) continue;
    const CellSides sides = middle_sides(layers[k]->grid());
    layers[k]->add_detail(*spec.detail, map, setting_of(spec.layers[k], sides), seed);
  }
}

std::size_t GroundLayers::first_with_detail() const {
  return spec.beyond && spec.beyond->has_detail_alone ? spec.beyond->first_layer : 0;
}

void GroundLayers::check_beyond() {
  const std::size_t first = spec.beyond->first_layer;
  const auto is_ground = [&](const Geodetic& place) {
    return std::any_of(layers.begin() + static_cast<std::ptrdiff_t>(first), layers.end(),
                       [&](const auto& layer) {
                         return Layer::Probe(*layer, LevelOfDetail{}).sample(place).has_value();
                       });
  };
  if (std::ranges::any_of(places_along_edge(layers[first - 1]->grid(), 1), is_ground)) return;
  const bool is_finer = layers[first]->cell_m() < layers[first - 1]->cell_m();
  throw InputError(
      spec.place,
      fmt::format("terrain {} has no ground anywhere along the edge of {}, so that nothing of "
                  "it would lie beyond{}",
                  spec.beyond->name, spec.name,
                  is_finer ? "; its cells are the finer ones: are the two exchanged?" : ""));
}

CellSides GroundLayers::middle_sides(const HeightGrid& grid) const {
  return cell_sides(grid, plane.site().body(), centre(grid.extent()));
}

LayerPlace GroundLayers::place_of(std::size_t layer) const {
  if (spec.layers.size() == 1) return LayerPlace::alone;
  return layer + 1 < spec.layers.size() ? LayerPlace::above : LayerPlace::last;
}

std::optional<std::size_t> GroundLayers::main_layer(const Geodetic& place) const {
  std::optional<std::size_t> most;
  double left = 1, largest_share = 0;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    Layer& layer = *layers[k];
    const auto sample = Layer::Probe(layer, layer.level_of_detail(0)).sample(place);
    if (!sample) continue;
    const double share = left * sample->weight;
    left -= share;
    if (share <= largest_share) continue;
    largest_share = share;
    most = k;
  }
  return most;
}

void GroundLayers::add_layers_to(Sha256& hash) const {
  for (const auto& layer : layers) layer->grid().add_to(hash);
  if (spec.detail) hash.add(fmt::format("{} {}", text(*spec.detail), seed));
  const auto& beyond = spec.beyond;
  if (beyond && beyond->has_detail_alone) hash.add(fmt::format(" from {}", beyond->first_layer));
}

std::string GroundLayers::layers_key() const {
  Sha256 hash;
  add_layers_to(hash);
  const Geodetic& site = plane.site().origin();
  hash.add(fmt::format("{} at {} {} {}", plane.site().body().name, site.lon_rad, site.lat_rad,
                       site.height_m));
  return hash.hex();
}

bool GroundLayers::has_rasters() const {
  const auto is_raster = [](const Surface& surface) {
    return std::holds_alternative<RasterSurface>(surface);
  };
  const auto has_raster = [](const SoilPatch& patch) { return patch.raster.has_value(); };
  return std::ranges::any_of(spec.layers, is_raster) ||
         std::ranges::any_of(spec.soil_patches, has_raster);
}

}  // namespace lsos
