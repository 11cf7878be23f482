// The shadow that terrain casts on the ground and on what stands on it. Nested square grids, finest
// around an eye, hold the heights from which given shares of the Sun are seen.
#pragma once

#include <array>
#include <vector>

#include "terrain/ground.h"

namespace lsos {

// The sector of ground that a camera sees, as horizontal directions from below its eye.
struct GroundSector {
  Vec3 ahead_S = Vec3::UnitX();
  double half_rad = 4;  // to each side; from pi on: all around
};

class TerrainShadow {
 public:
  // `sun_S`: unit vector from the eye to the centre of a disc of angular radius `disc_rad`. Covers
  // all distances at which ground may stand before the disc, for places in the sector alone.
  TerrainShadow(const Ground& ground, const Vec3& eye_S_m, const Vec3& sun_S, double disc_rad,
                const GroundSector& sector = {});

  // Share 0..1 of the disc that the ground at or below a point sees over the terrain; what the
  // ground's own slope there hides is not deducted. Points are relative to the eye, in site axes.
  double on_ground(const Vec3& p_m) const;
  // The same for the point itself.
  double at(const Vec3& p_m) const;

 private:
  // The disc is cut into horizontal slices, each with its own limit: near ground may hide the lower
  // ones from a height at which distant ground hides none, or vice versa.
  static constexpr int slices = 16;
  // Heights at one place above the eye's plane. From limit k upwards a ray to the lower edge of
  // slice k clears all terrain; the last limit is that of the top of the disc.
  using Limits = std::array<double, slices + 1>;
  using StoredLimits = std::array<float, slices + 1>;
  // A square grid whose rows run towards the Sun.
  struct Level {
    double half_m = 0, cell_m = 0;
    std::vector<float> ground_m;  // above the eye's plane
    std::vector<StoredLimits> limits_m;
    std::vector<float> share;  // of the disc, seen by the ground
  };
  struct GridPosition {
    const Level* level;
    std::size_t node;
    double right, up;  // shares of a cell
  };
  Level sampled(const Ground& ground, const Vec3& eye_S_m, double half_m) const;
  // The first column of a row that lies in the sector, or the number of columns if none does.
  int first_seen(const Level& level, int row) const;
  void march(const Ground& ground, const Vec3& eye_S_m);
  // raise() applies ground of that height at a place; lower() carries the limits on by that
  // distance away from the Sun.
  void raise(Limits& limits_m, double ground_m) const;
  void lower(Limits& limits_m, double by_m) const;
  // Share of the disc that is seen from that height.
  double share_of(double height_m, const Limits& limits_m, double cell_m) const;
  Limits at_edge(double across_m) const;
  void sweep(Level& level, const Level* coarser) const;
  // The position in the finest level that holds it, from level `from` on; `level` is nullptr beyond
  // all levels.
  GridPosition grid_position(double along_m, double across_m, std::size_t from = 0) const;
  static Limits unobstructed();
  static Limits limits_at(const GridPosition& grid_position);
  static double share_at(const GridPosition& grid_position);

  Vec3 up_S_, along_S_, across_S_;
  std::array<double, slices + 1> slopes_;  // of the rays
  std::array<double, slices> areas_;       // of the slices, as shares of the disc
  double radius_m_;                        // of the body
  GroundSector sector_;
  std::vector<Limits> edge_;   // of the coarsest level, towards the Sun
  std::vector<Level> levels_;  // from fine to coarse
};

}  // namespace lsos
