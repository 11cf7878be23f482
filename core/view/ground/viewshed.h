// Which places of a map an observer sees. On the map the ground is linear between its cells. Small
// maps: along the line to each place, over all that it crosses between cells. Others: rays over the
// ground, outwards from the observer, each with the highest elevation met so far; a place is seen
// where it stands above that of the rays on either side, just before it.
#pragma once

#include <optional>
#include <vector>

#include "terrain/raster/map_grid.h"
#include "view/ground/ground_probes.h"
#include "view/ground/map_heights.h"

namespace lsos {

// What of the surroundings is looked at.
struct ViewSector {
  double azimuth_low_rad = 0;  // clockwise from north
  double width_rad = 0;
  double nearest_m = 0;  // along the surface, of what is asked for
  double farthest_m = 0;
};
// All that the cells of the map lie in.
ViewSector sector_of(const MapGrid& grid, const SiteFrame& site, const Geodetic& observer);

struct Observer {
  Geodetic place;     // its height is that of the eye, above the reference surface
  double cell_m = 1;  // of the map: what is much smaller is left out of the ground
  // Heights above a plane, distances as along the surface. Else lines are straight and the body is
  // round.
  bool is_flat = false;
};

class Viewshed {
 public:
  // `heights`: of the map; null: all is as the ground has it.
  Viewshed(const Ground& ground, const MapHeights* heights, const Observer& observer,
           const ViewSector& sector);

  // Rays may be marched side by side, each thread with probes of its own; all of them first. Small
  // maps need none.
  std::size_t ray_count() const { return ray_count_; }
  GroundProbes probes() const { return {*ground_, observer_.cell_m}; }
  void march(std::size_t ray, GroundProbes& probes);

  // In the sector; of a map that is given, on it. Nothing beyond reach_m() is seen.
  bool sees(const Vec3& target_S_m) const;
  // Beyond, the body itself hides all ground and what stands on it; flat maps end there.
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
  // Where a ray's samples lie on the map; absent where it has no such place.
  using Track = std::vector<std::optional<GridCoordinates>>;
  Track track(double azimuth_rad) const;
  void add_between(std::size_t first, std::size_t last, double azimuth_rad, Track& track) const;
  std::optional<GridCoordinates> on_map(double azimuth_rad, double distance_m) const;
  double ground_slope(const Vec3& over_S_m, double height_m) const;

  // On the map, where it goes around the body next to the column `near_u`.
  std::optional<GridCoordinates> place_px(const Geodetic& place, double near_u) const;
  // The eye, where lines over the map are few and straight.
  std::optional<GridCoordinates> eye_of_lines() const;
  // The ground's, on the way to a target.
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
  double fineness_ = 1;                      // cells between samples
  std::vector<double> distances_m_;          // of a ray's samples
  std::vector<std::vector<float>> highest_;  // slope met so far, ray by ray, as far as the map goes
};

}  // namespace lsos
