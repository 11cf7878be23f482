// Ground computed from landforms at known places, on a grid around a place of the body: the same
// wherever the site is.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "terrain/detail/craters.h"
#include "terrain/detail/landforms.h"
#include "terrain/grid/height_grid.h"
#include "terrain/grid/stereographic.h"

namespace lsos {

namespace {

Vec3 direction(double lon_rad, double lat_rad) {
  const double cos_lat = std::cos(lat_rad);
  return {cos_lat * std::cos(lon_rad), cos_lat * std::sin(lon_rad), std::sin(lat_rad)};
}

class ReliefGrid : public HeightGrid {
 public:
  ReliefGrid(const ReliefSurface& surface, const std::optional<CraterPopulation>& craters,
             std::uint64_t seed, const SitePlane& plane)
      : surface_(surface),
        craters_(craters),
        seed_(seed),
        plane_(plane),
        radius_m_(plane.site().body().equatorial_radius_m),
        map_(plane.site().body(), surface.lon_rad, surface.lat_rad),
        exact_{[this](const PlanePoint& at) { return coordinates(plane_.place(at)); }} {
    for (const Landform& form : surface_.landforms) {
      directions_.push_back(direction(form.lon_rad, form.lat_rad));
    }
  }

  HeightTile tile(const TileKey& key) const override {
    HeightTile tile(key);
    tile.set_ground_everywhere();
    const std::vector<std::size_t> landforms = landforms_of(key);
    const int last = HeightTile::first_node + HeightTile::nodes;
    for (int row = HeightTile::first_node; row < last; ++row) {
      for (int column = HeightTile::first_node; column < last; ++column) {
        const Vec3 up = map_.direction(node(key, column, row));
        tile.height_m(column, row) = surface_.height_m + landforms_m(landforms, up);
      }
    }
    for (const Crater& crater : craters_of(key)) add(crater, tile);
    return tile;
  }
  int coarsest_level() const override { return 12; }
  Patch patch(const PatchKey& key) const override { return Patch(key, exact_); }
  std::optional<GridPoint> exact(const PlanePoint& at) const override {
    return exact_grid_point(exact_, at);
  }
  std::optional<GridCoordinates> coordinates(const Geodetic& place) const override {
    const PlanePoint at = map_.at(place);
    return GridCoordinates{at.x_m / surface_.spacing_m, at.y_m / surface_.spacing_m};
  }
  std::optional<Geodetic> place(const GridCoordinates& at) const override {
    return map_.place({at.u * surface_.spacing_m, at.v * surface_.spacing_m});
  }
  void add_to(Sha256& hash) const override {
    hash.add(fmt::format("relief {} {} {} {} {}", surface_.lon_rad, surface_.lat_rad,
                         surface_.height_m, surface_.spacing_m, seed_));
    for (const Landform& f : surface_.landforms) {
      hash.add(fmt::format("\n{} {} {} {} {}", f.lon_rad, f.lat_rad, f.diameter_m, f.depth_m,
                           f.rim_height_m));
    }
  }

 private:
  PlanePoint node(const TileKey& key, int column, int row) const {
    const auto at_m = [&](std::int64_t number) {
      return from_level(static_cast<double>(number), key.level) * surface_.spacing_m;
    };
    return {at_m(key.column * HeightTile::cells + column), at_m(key.row * HeightTile::cells + row)};
  }
  std::vector<Crater> craters_of(const TileKey& key) const {
    if (!craters_) return {};
    const int last = HeightTile::first_node + HeightTile::nodes - 1;
    return craters_touching(
        *craters_, seed_,
        {node(key, HeightTile::first_node, HeightTile::first_node), node(key, last, last)},
        // Coarse levels have only craters at least as large as their cells.
        surface_.spacing_m * std::max(relief_crater_min_cells, std::ldexp(1.0, key.level)));
  }
  void add(const Crater& crater, HeightTile& tile) const {
    const double reach_m = crater_reach * crater.diameter_m / 2;
    const double spacing_m = std::ldexp(surface_.spacing_m, tile.key().level);
    const PlanePoint first = node(tile.key(), HeightTile::first_node, HeightTile::first_node);
    const auto number = [&](double from_first_m) {
      const double counted = std::clamp(from_first_m / spacing_m, 0.0, HeightTile::nodes - 1.0);
      return HeightTile::first_node + static_cast<int>(counted);
    };
    const int row_high = number(crater.centre.y_m + reach_m - first.y_m);
    const int column_high = number(crater.centre.x_m + reach_m - first.x_m);
    for (int row = number(crater.centre.y_m - reach_m - first.y_m); row <= row_high; ++row) {
      for (int column = number(crater.centre.x_m - reach_m - first.x_m); column <= column_high;
           ++column) {
        const PlanePoint at = node(tile.key(), column, row);
        const double dx = at.x_m - crater.centre.x_m, dy = at.y_m - crater.centre.y_m;
        tile.height_m(column, row) += crater_height_m(
            std::sqrt(dx * dx + dy * dy) / (crater.diameter_m / 2), crater.depth_m, crater.rim_m);
      }
    }
  }
  // Landforms that reach into the tile.
  std::vector<std::size_t> landforms_of(const TileKey& key) const {
    const int last = HeightTile::first_node + HeightTile::nodes - 1;
    const Vec3 corner = map_.direction(node(key, HeightTile::first_node, HeightTile::first_node));
    const Vec3 opposite = map_.direction(node(key, last, last));
    const Vec3 middle = (corner + opposite).normalized();
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < directions_.size(); ++k) {
      const double reach_m = crater_reach * surface_.landforms[k].diameter_m / 2;
      // A chord through the body is shorter than the arc along it: none is missed.
      const double distance_m =
          radius_m_ * ((middle - directions_[k]).norm() - 1.1 * (middle - corner).norm());
      if (distance_m < reach_m) found.push_back(k);
    }
    return found;
  }
  double landforms_m(const std::vector<std::size_t>& landforms, const Vec3& up) const {
    double sum_m = 0;
    for (const std::size_t k : landforms) {
      const Landform& form = surface_.landforms[k];
      const double chord = (up - directions_[k]).norm();
      const double r = 2 * radius_m_ * std::asin(std::min(1.0, chord / 2)) / (form.diameter_m / 2);
      if (r < crater_reach) sum_m += landform_height_m(form, r);
    }
    return sum_m;
  }

  ReliefSurface surface_;
  std::optional<CraterPopulation> craters_;
  std::uint64_t seed_;
  const SitePlane& plane_;
  double radius_m_;
  Stereographic map_;
  std::vector<Vec3> directions_;
  ExactMap exact_;
};

}  // namespace

std::unique_ptr<HeightGrid> make_relief_grid(const ReliefSurface& surface,
                                             const std::optional<CraterPopulation>& craters,
                                             std::uint64_t seed, const SitePlane& plane) {
  return std::make_unique<ReliefGrid>(surface, craters, seed, plane);
}

}  // namespace lsos
