#include "terrain/ground.h"

#include <array>
#include <cmath>

#include "terrain/height_grid.h"
#include "terrain/key_cache.h"

namespace lsos {

namespace {

std::unique_ptr<HeightGrid> make_grid(const TerrainSpec& spec, const SitePlane& plane,
                                      std::uint64_t seed) {
  if (const auto* surface = std::get_if<RasterSurface>(&spec.surface)) {
    return make_raster_grid(*surface, spec.place, plane);
  }
  if (const auto* surface = std::get_if<CraterSurface>(&spec.surface)) {
    return make_generated_grid(*surface, plane, seed);
  }
  return make_generated_grid(std::get<PlaneSurface>(spec.surface), plane);
}

}  // namespace

struct Ground::Impl {
  Impl(const TerrainSpec& terrain, const SiteFrame& site, std::uint64_t seed)
      : spec(terrain), plane(site), grid(make_grid(spec, plane, seed)) {}

  std::shared_ptr<const HeightTile> tile(const TileKey& key) {
    return tiles.get(key, [this](const TileKey& wanted) { return grid->tile(wanted); });
  }

  // The coarsest good patch that holds the point, or the finest one where none is good.
  std::shared_ptr<const Patch> patch(const PlanePoint& at) {
    for (int level = 0;; ++level) {
      auto found = patches.get(Patch::key_of(at, level),
                               [this](const PatchKey& key) { return grid->patch(key); });
      if (found->is_good() || level == Patch::finest_level) return found;
    }
  }

  TerrainSpec spec;
  SitePlane plane;
  std::unique_ptr<HeightGrid> grid;
  KeyCache<TileKey, HeightTile> tiles{2048};  // 36 kB each: up to 150 MB
  KeyCache<PatchKey, Patch> patches{16384};   // 0.3 kB each
};

Ground::Ground(const TerrainSpec& spec, const SiteFrame& site, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(spec, site, seed)) {}
Ground::~Ground() = default;

const SiteFrame& Ground::site() const { return impl_->plane.site(); }
const Soil& Ground::soil() const { return impl_->spec.soil; }

std::string Ground::hash() const {
  Sha256 hash;
  impl_->grid->add_to(hash);
  return hash.hex();
}

std::vector<Fault> Ground::advice() const {
  const std::string advice = impl_->grid->advice();
  if (advice.empty()) return {};
  return {{Severity::warning, impl_->spec.place, advice}};
}

std::optional<double> Ground::elevation_m(const Geodetic& place) const {
  const auto at = impl_->grid->coordinates(place);
  if (!at) return {};
  double u = at->u;
  if (!impl_->grid->extent().bring_inside(u, at->v)) return {};
  const CellPoint cell(u, at->v);
  const double height_m = surface_height(*impl_->tile(cell.tile()), cell).height_m;
  return std::isnan(height_m) ? std::nullopt : std::optional(height_m);
}

// What was last used, by parity of the key: wheels on both sides of a border keep their own.
// Shared pointers: the ground may drop a piece while this probe still uses it.
struct Ground::Probe::Impl {
  explicit Impl(Ground::Impl& of) : ground(of) {}

  // Patches that are not split any further never overlap, so that the one last used answers for
  // every point it holds.
  const Patch& patch(const PlanePoint& at) {
    if (last_patch != nullptr && last_patch->holds(at)) return *last_patch;
    const PatchKey key = Patch::key_of(at, 0);
    std::shared_ptr<const Patch>& kept = patches[2 * (key.row & 1) + (key.column & 1)];
    if (!kept || !kept->holds(at)) kept = ground.patch(at);
    last_patch = kept.get();
    return *kept;
  }
  const HeightTile& tile(const TileKey& key) {
    std::shared_ptr<const HeightTile>& kept = tiles[2 * (key.row & 1) + (key.column & 1)];
    if (!kept || kept->key() != key) kept = ground.tile(key);
    return *kept;
  }

  Ground::Impl& ground;
  std::array<std::shared_ptr<const Patch>, 4> patches;
  std::array<std::shared_ptr<const HeightTile>, 4> tiles;
  const Patch* last_patch = nullptr;  // one of them
};

Ground::Probe::Probe(const Ground& ground) : impl_(std::make_unique<Impl>(*ground.impl_)) {}
Ground::Probe::~Probe() = default;
Ground::Probe::Probe(Probe&&) noexcept = default;
Ground::Probe& Ground::Probe::operator=(Probe&&) noexcept = default;

GroundSample Ground::Probe::sample(const Vec3& p_S_m) {
  const Ground::Impl& ground = impl_->ground;
  const Standing standing = ground.plane.standing(p_S_m);
  if (!standing.is_near) return {};

  const Patch& patch = impl_->patch(standing.at);
  GridPoint at;
  if (patch.is_good()) {
    at = patch.at(standing.at);
  } else if (const auto exact = ground.grid->exact(standing.at)) {
    at = *exact;
  } else {
    return {};
  }
  if (!ground.grid->extent().bring_inside(at.u, at.v)) return {};
  const CellPoint cell(at.u, at.v);
  const SurfaceHeight surface = surface_height(impl_->tile(cell.tile()), cell);
  if (std::isnan(surface.height_m)) return {};

  GroundSample sample;
  sample.elevation_m = surface.height_m;
  sample.up_S = standing.up_S;
  sample.gap_m = standing.height_m - surface.height_m;
  // The surface is where height(p) - surface(u(x, y), v(x, y)) is 0; its normal is that gradient.
  // The gradients of x and y grow from the asked point down to the surface.
  const double by_x = surface.by_u_m * at.u_by_x + surface.by_v_m * at.v_by_x;
  const double by_y = surface.by_u_m * at.u_by_y + surface.by_v_m * at.v_by_y;
  const double growth = standing.radius_m / (standing.radius_m - sample.gap_m);
  const Vec3 gradient_S =
      standing.up_S - growth * (by_x * standing.grad_x_S + by_y * standing.grad_y_S);
  sample.normal_S = gradient_S * (1 / std::sqrt(gradient_S.squaredNorm()));
  return sample;
}

}  // namespace lsos
