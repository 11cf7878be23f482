// What every kind of ground is turned into: heights on a regular grid, and the way there from the
// site plane. All functions are pure functions of their arguments and may be called from any
// thread.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "base/sha256.h"
#include "terrain/height_tile.h"
#include "terrain/patch.h"
#include "terrain/terrain_spec.h"

namespace lsos {

// Grid coordinates beyond these bounds have no ground.
struct GridExtent {
  double u_low = -std::numeric_limits<double>::infinity();
  double u_high = std::numeric_limits<double>::infinity();
  double v_low = -std::numeric_limits<double>::infinity();
  double v_high = std::numeric_limits<double>::infinity();
  // Columns once around the body; u is brought into u_low..u_low + period. 0: not around.
  double period = 0;

  // Brings u into the extent; false where (u, v) lies outside.
  bool bring_inside(double& u, double v) const {
    if (period > 0) u -= period * std::floor((u - u_low) / period);
    return u >= u_low && u <= u_high && v >= v_low && v <= v_high;
  }
};

class HeightGrid {
 public:
  virtual ~HeightGrid() = default;

  virtual HeightTile tile(const TileKey& key) const = 0;
  // The map on that square; not good where the square is too large.
  virtual Patch patch(const PatchKey& key) const = 0;
  virtual std::optional<GridPoint> exact(const PlanePoint& at) const = 0;
  virtual std::optional<GridCoordinates> coordinates(const Geodetic& place) const = 0;
  // All that decides the heights.
  virtual void add_to(Sha256& hash) const = 0;
  // What would make it faster; "" for nothing.
  virtual std::string advice() const { return {}; }

  const GridExtent& extent() const { return extent_; }

 protected:
  GridExtent extent_;
};

// A plane, with or without craters. `plane` must outlive the grid.
std::unique_ptr<HeightGrid> make_generated_grid(const PlaneSurface& surface,
                                                const SitePlane& plane);
std::unique_ptr<HeightGrid> make_generated_grid(const CraterSurface& surface,
                                                const SitePlane& plane, std::uint64_t seed);
// Throws InputError at `place`: cannot be opened, has no such band, no CRS, or is on another body.
std::unique_ptr<HeightGrid> make_raster_grid(const RasterSurface& surface, const Place& place,
                                             const SitePlane& plane);

}  // namespace lsos
