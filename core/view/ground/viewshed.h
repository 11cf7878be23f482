// Viewshed: which places of a map an observer sees. On the map the ground is linear between cells.
// On small maps the line to each place is examined wherever it crosses from cell to cell. On others
// rays run outwards from the observer over the ground, each with the highest elevation met so far;
// a place is seen where it stands above that of the rays on either side, just before it.
#pragma once

#include <optional>
#include <vector>

#include "terrain/raster/map_grid.h"
#include "view/ground/ground_probes.h"
#include "view/ground/map_heights.h"

namespace lsos {

// The part of the surroundings that is examined.
struct ViewSector {
  double azimuth_low_rad = 0;  // clockwise from north
  double width_rad = 0;
  double nearest_m = 0;  // along the surface, of the places requested
  double farthest_m = 0;
};
// The sector that holds all cells of the map.
ViewSector sector_of(const MapGrid& grid, const SiteFrame& site, const Geodetic& observer);

struct Observer {
  Geodetic place;     // its height is that of the eye, above the reference surface
  double cell_m = 1;  // of the map; much smaller detail of the ground is left out
  // Heights are above a plane, and distances are those along the surface. Otherwise lines are
  // straight and the body is round.
  bool is_flat = false;
};

class Viewshed {
 public:
  // `heights`: those of the map's cells; null: the ground itself is sampled everywhere.
  Viewshed(const Ground& ground, const MapHeights* heights, const Observer& observer,
           const ViewSector& sector);

  // Rays may be marched in parallel, each thread with its own probes; all must be marched before
  // sees() is called. Small maps need none.
  std::size_t ray_count() const { return ray_count_; }
  GroundProbes probes() const { return GroundProbes(*ground_); }
  void march(std::size_t ray, GroundProbes& probes);

  // The target must lie in the sector, and on the map if one is given. Nothing beyond reach_m() is
  // seen.
  bool sees(const Vec3& target_S_m) const;
  // Distance beyond which the body itself hides all ground and what stands on it; flat maps end
  // there.
  double reach_m() const;

 private:
  struct Polar {
    double azimuth_rad;
    double distance_m;  // along the surface
    double slope;       // tangent of the elevation
  };
  Polar polar(const Vec3& p_S_m) const;
  Vec3 p_S_m(double azimuth_rad, double distance_m) const;
  void spread_rays();
  void add_distances();
  // Coordinates of a ray's samples on the map; absent where the map has no such place.
  using Track = std::vector<std::optional<GridCoordinates>>;
  Track track(double azimuth_rad) const;
  void add_between(std::size_t first, std::size_t last, double azimuth_rad, Track& track) const;
  std::optional<GridCoordinates> on_map(double azimuth_rad, double distance_m) const;
  double ground_slope(const Vec3& over_S_m, double height_m) const;

  // Coordinates on the map; if it goes around the body, those next to the column `near_u`.
  std::optional<GridCoordinates> place_px(const Geodetic& place, double near_u) const;
  // Coordinates of the eye where lines over the map are few and straight; else absent.
  std::optional<GridCoordinates> eye_of_lines() const;
  // The steepest slope of the ground between the eye and a target.
  double steepest_before(const Polar& target, const GridCoordinates& target_px) const;

  const Ground* ground_;
  const MapHeights* heights_;
  Observer observer_;
  ViewSector sector_;
  Vec3 eye_S_m_, up_S_, north_S_, east_S_;
  double radius_m_;                        // of the eye from the centre of a sphere
  std::optional<GridCoordinates> eye_px_;  // absent: rays are marched
  std::size_t ray_count_ = 0;
  double spacing_rad_ = 0;
  double cells_per_sample_ = 1;                 // cells between samples
  std::vector<double> distances_m_;             // of a ray's samples
  std::vector<std::vector<float>> max_slopes_;  // slope so far, by ray, as far as the map goes
};

}  // namespace lsos
