// The shadow that terrain throws, on ground and on what stands on it: for nested squares of places,
// finest about an eye, how high one has to be to see the Sun.
#pragma once

#include <vector>

#include "terrain/ground.h"

namespace lsos {

// What a camera sees of the ground, as directions over it from under its eye.
struct GroundSector {
  Vec3 ahead_S = Vec3::UnitX();
  double half_rad = 4;  // to each side; from pi on: all around
};

class TerrainShadow {
 public:
  // `sun_S`: unit, to the middle of a disc of that angular radius, as seen from the eye. Reaches as
  // far as ground may stand before it. Only of what lies in the sector.
  TerrainShadow(const Ground& ground, const Vec3& eye_S_m, const Vec3& sun_S, double disc_rad,
                const GroundSector& sector = {});

  // Share 0..1 of the disc over terrain that the ground at or under a point sees, without what the
  // ground's own slope there hides. Points are from the eye, site axes.
  double on_ground(const Vec3& p_m) const;
  // The same of the point itself.
  double at(const Vec3& p_m) const;

 private:
  // Nodes in rows towards the Sun.
  struct Level {
    double half_m = 0, cell_m = 0;
    std::vector<float> ground_m;       // over the eye's plane
    std::vector<float> dark_m, lit_m;  // below: none of the disc is seen; above: all of it
    std::vector<float> share;          // seen by the ground
  };
  struct Spot {
    const Level* level;
    std::size_t node;
    double right, up;  // shares of a cell
  };
  // Heights at one place: below the first one sees nothing of the disc, above the second all.
  struct Limits {
    double dark_m, lit_m;
  };
  Level sampled(const Ground& ground, const Vec3& eye_S_m, double half_m) const;
  // The first column of a row that lies in the sector, or as many as there are.
  int first_seen(const Level& level, int row) const;
  void march(const Ground& ground, const Vec3& eye_S_m);
  Limits at_edge(double across_m) const;
  void sweep(Level& level, const Level* coarser) const;
  // In the finest level that holds it, from a given one on; level is nullptr beyond all.
  Spot spot(double along_m, double across_m, std::size_t from = 0) const;
  static double value(const std::vector<float>& values, const Spot& spot);

  Vec3 up_S_, along_S_, across_S_;
  double top_slope_, low_slope_;  // of rays to the disc's edges
  double radius_m_;               // of the body
  GroundSector sector_;
  std::vector<Limits> edge_;   // of the last level, towards the Sun
  std::vector<Level> levels_;  // from fine to coarse
};

}  // namespace lsos
