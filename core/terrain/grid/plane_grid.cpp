// Level or tilted ground without detail of its own.
#include <fmt/format.h>

#include <cmath>

#include "terrain/grid/height_grid.h"

namespace lsos {

namespace {

constexpr double spacing_m = 16;

// A plane is linear in the site plane's coordinates, which bicubic interpolation keeps.
class PlaneGrid : public HeightGrid {
 public:
  PlaneGrid(const PlaneSurface& surface, const SitePlane& plane)
      : surface_(surface), plane_(plane) {
    // Metres of the site plane are true metres only at its own distance from the centre.
    const double true_per_plane_m =
        (plane.site().body().equatorial_radius_m + surface.height_m) / plane.distance_m();
    const double rise = std::tan(surface.slope_rad) * true_per_plane_m * spacing_m;
    by_u_m_ = -rise * std::sin(surface.downslope_azimuth_rad);
    by_v_m_ = -rise * std::cos(surface.downslope_azimuth_rad);
  }

  HeightTile tile(const TileKey& key) const override {
    HeightTile tile(key);
    const int last = HeightTile::first_node + HeightTile::nodes;
    for (int row = HeightTile::first_node; row < last; ++row) {
      for (int column = HeightTile::first_node; column < last; ++column) {
        const double u = node(key.column * HeightTile::cells + column, key.level);
        const double v = node(key.row * HeightTile::cells + row, key.level);
        tile.height_m(column, row) = surface_.height_m + (by_u_m_ * u + by_v_m_ * v);
      }
    }
    tile.set_ground_everywhere();
    return tile;
  }
  int coarsest_level() const override { return 16; }
  Patch patch(const PatchKey&) const override { return Patch::scaling(spacing_m); }
  std::optional<GridPoint> exact(const PlanePoint& at) const override {
    return Patch::scaling(spacing_m).at(at);
  }
  std::optional<GridCoordinates> coordinates(const Geodetic& place) const override {
    const ProjectedPoint projected =
        plane_.projected(plane_.site().p_S_m({place.lon_rad, place.lat_rad, 0}));
    if (!projected.is_near) return {};
    return GridCoordinates{projected.at.x_m / spacing_m, projected.at.y_m / spacing_m};
  }
  std::optional<Geodetic> place(const GridCoordinates& at) const override {
    return plane_.place({at.u * spacing_m, at.v * spacing_m});
  }
  void add_to(Sha256& hash) const override {
    hash.add(fmt::format("plane {} {} {}", surface_.height_m, surface_.slope_rad,
                         surface_.downslope_azimuth_rad));
  }

 private:
  static double node(std::int64_t number, int level) {
    return from_level(static_cast<double>(number), level);
  }

  PlaneSurface surface_;
  const SitePlane& plane_;
  double by_u_m_;
  double by_v_m_;
};

}  // namespace

std::unique_ptr<HeightGrid> make_plane_grid(const PlaneSurface& surface, const SitePlane& plane) {
  return std::make_unique<PlaneGrid>(surface, plane);
}

}  // namespace lsos
