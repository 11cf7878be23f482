// Interface of every kind of ground: heights on a regular grid, and the map to it from the site
// plane. All functions are pure functions of their arguments and may be called from any thread.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/sha256.h"
#include "terrain/grid/height_tile.h"
#include "terrain/grid/patch.h"
#include "terrain/spec/terrain_spec.h"

namespace lsos {

// Grid coordinates beyond these bounds have no ground.
struct GridExtent {
  double u_low = -std::numeric_limits<double>::infinity();
  double u_high = std::numeric_limits<double>::infinity();
  double v_low = -std::numeric_limits<double>::infinity();
  double v_high = std::numeric_limits<double>::infinity();
  // Columns once around the body, perhaps more than the grid has; u is brought into u_low..u_low +
  // period. 0: the grid's columns do not lead around the body.
  double period = 0;

  // Whether the last column ends where the first begins.
  bool goes_around() const { return period > 0 && u_high - u_low >= period; }

  // Brings u into the extent; false where (u, v) lies outside.
  bool bring_inside(double& u, double v) const {
    if (period > 0) u -= period * std::floor((u - u_low) / period);
    return u >= u_low && u <= u_high && v >= v_low && v <= v_high;
  }
};

// Converts a grid coordinate to the cells of a level, whose first one holds the grid's first
// 2^level; and back.
inline double on_level(double u, int level) {
  return level == 0 ? u : std::ldexp(u + 0.5, -level) - 0.5;
}
inline double from_level(double u, int level) {
  return level == 0 ? u : std::ldexp(u + 0.5, level) - 0.5;
}

class HeightGrid {
 public:
  virtual ~HeightGrid() = default;

  // `key.level` up to coarsest_level().
  virtual HeightTile tile(const TileKey& key) const = 0;
  virtual int coarsest_level() const = 0;
  // Fit of the map from the site plane on that square; not good where the square is too large.
  virtual Patch patch(const PatchKey& key) const = 0;
  virtual std::optional<GridPoint> exact(const PlanePoint& at) const = 0;
  virtual std::optional<GridCoordinates> coordinates(const Geodetic& place) const = 0;
  // Inverse of coordinates(), with height 0; nullopt where the grid lies beyond what is mapped.
  virtual std::optional<Geodetic> place(const GridCoordinates& at) const = 0;
  // Adds all that decides the heights.
  virtual void add_to(Sha256& hash) const = 0;
  // Adds when what add_to() leaves out was last changed on this machine.
  virtual void add_change_to(Sha256&) const {}
  // Files that have been written, replaced or removed since they were opened.
  virtual std::vector<std::string> changed_files() const { return {}; }
  // Warnings: what would make the ground faster, and what its heights may mean instead.
  virtual std::vector<std::string> advice() const { return {}; }

  const GridExtent& extent() const { return extent_; }

 protected:
  GridExtent extent_;
};

// `plane` must outlive the grid.
std::unique_ptr<HeightGrid> make_plane_grid(const PlaneSurface& surface, const SitePlane& plane);
// Craters of at least so many cells belong to the relief; smaller ones to the detail upon it.
inline constexpr double relief_crater_min_cells = 12;
std::unique_ptr<HeightGrid> make_relief_grid(const ReliefSurface& surface,
                                             const std::optional<CraterPopulation>& craters,
                                             std::uint64_t seed, const SitePlane& plane);
// Throws InputError at `place`: the raster cannot be opened, has no such band or no CRS, or is on
// another body.
std::unique_ptr<HeightGrid> make_raster_grid(const RasterSurface& surface, const Place& place,
                                             const SitePlane& plane);

}  // namespace lsos
