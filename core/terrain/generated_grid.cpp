// Ground computed from a few numbers: planes and fields of craters.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "terrain/craters.h"
#include "terrain/height_grid.h"

namespace lsos {

namespace {

// A plane is linear in the site plane's coordinates, which bicubic interpolation keeps.
struct PlaneHeights {
  PlaneHeights(const PlaneSurface& surface, const SitePlane& plane) : height_m(surface.height_m) {
    // Metres of the site plane are true metres at its own distance from the centre only.
    const double true_per_plane_m =
        (plane.site().body().equatorial_radius_m + surface.height_m) / plane.distance_m();
    const double rise = std::tan(surface.slope_rad) * true_per_plane_m;
    by_x = -rise * std::sin(surface.downslope_azimuth_rad);
    by_y = -rise * std::cos(surface.downslope_azimuth_rad);
  }

  double at(double x_m, double y_m) const { return height_m + (by_x * x_m + by_y * y_m); }

  double height_m;
  double by_x;
  double by_y;
};

std::string text(const PlaneSurface& s) {
  return fmt::format("plane {} {} {}", s.height_m, s.slope_rad, s.downslope_azimuth_rad);
}

class GeneratedGrid : public HeightGrid {
 public:
  GeneratedGrid(const SitePlane& plane, double spacing_m) : plane_(plane), spacing_m_(spacing_m) {}

  Patch patch(const PatchKey&) const override { return Patch::scaling(spacing_m_); }
  std::optional<GridPoint> exact(const PlanePoint& at) const override {
    return Patch::scaling(spacing_m_).at(at);
  }
  std::optional<GridCoordinates> coordinates(const Geodetic& place) const override {
    const Standing standing =
        plane_.standing(plane_.site().p_S_m({place.lon_rad, place.lat_rad, 0}));
    if (!standing.is_near) return {};
    return GridCoordinates{standing.at.x_m / spacing_m_, standing.at.y_m / spacing_m_};
  }

 protected:
  // A tile with ground everywhere and heights by `height_m(x_m, y_m)`.
  template <class HeightAt>
  HeightTile filled(const TileKey& key, const HeightAt& height_m) const {
    HeightTile tile(key);
    const int last = HeightTile::first_node + HeightTile::nodes;
    for (int row = HeightTile::first_node; row < last; ++row) {
      for (int column = HeightTile::first_node; column < last; ++column) {
        const PlanePoint at = node(key, column, row);
        tile.height_m(column, row) = height_m(at.x_m, at.y_m);
      }
    }
    for (int row = 0; row < HeightTile::cells; ++row) {
      for (int column = 0; column < HeightTile::cells; ++column) tile.set_ground(column, row);
    }
    return tile;
  }
  PlanePoint node(const TileKey& key, int column, int row) const {
    return {static_cast<double>(key.column * HeightTile::cells + column) * spacing_m_,
            static_cast<double>(key.row * HeightTile::cells + row) * spacing_m_};
  }

 private:
  const SitePlane& plane_;
  double spacing_m_;
};

class PlaneGrid : public GeneratedGrid {
 public:
  PlaneGrid(const PlaneSurface& surface, const SitePlane& plane)
      : GeneratedGrid(plane, 16), surface_(surface), base_(surface, plane) {}

  HeightTile tile(const TileKey& key) const override {
    return filled(key, [this](double x_m, double y_m) { return base_.at(x_m, y_m); });
  }
  void add_to(Sha256& hash) const override { hash.add(text(surface_)); }

 private:
  PlaneSurface surface_;
  PlaneHeights base_;
};

// Twelve nodes across the smallest crater draw it; finer than 0.25 m is not worth the memory,
// coarser than 0.5 m would round off the crests.
double crater_spacing_m(const CraterSurface& s) {
  return std::clamp(s.diameter_min_m / 12, 0.25, 0.5);
}

class CraterGrid : public GeneratedGrid {
 public:
  CraterGrid(const CraterSurface& surface, const SitePlane& plane, std::uint64_t seed)
      : GeneratedGrid(plane, crater_spacing_m(surface)),
        surface_(surface),
        base_(surface.base, plane),
        seed_(seed) {}

  HeightTile tile(const TileKey& key) const override {
    const int last = HeightTile::first_node + HeightTile::nodes - 1;
    const std::vector<Crater> craters =
        craters_touching(surface_, seed_, node(key, HeightTile::first_node, HeightTile::first_node),
                         node(key, last, last));
    return filled(key, [&](double x_m, double y_m) {
      double height_m = base_.at(x_m, y_m);
      for (const Crater& crater : craters) {
        const double distance_m = std::hypot(x_m - crater.centre.x_m, y_m - crater.centre.y_m);
        height_m += crater_height_m(distance_m, crater.diameter_m, surface_.depth_to_diameter);
      }
      return height_m;
    });
  }
  void add_to(Sha256& hash) const override {
    hash.add(fmt::format("craters {} on {} {} {} {} {} {}", seed_, text(surface_.base),
                         surface_.diameter_min_m, surface_.diameter_max_m, surface_.exponent,
                         surface_.density_pm2, surface_.depth_to_diameter));
  }

 private:
  CraterSurface surface_;
  PlaneHeights base_;
  std::uint64_t seed_;
};

}  // namespace

std::unique_ptr<HeightGrid> make_generated_grid(const PlaneSurface& surface,
                                                const SitePlane& plane) {
  return std::make_unique<PlaneGrid>(surface, plane);
}

std::unique_ptr<HeightGrid> make_generated_grid(const CraterSurface& surface,
                                                const SitePlane& plane, std::uint64_t seed) {
  return std::make_unique<CraterGrid>(surface, plane, seed);
}

}  // namespace lsos
