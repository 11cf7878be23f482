// The shadow that terrain throws, on ground and on what stands on it: for nested squares of places,
// finest about an eye, how high one has to be to see how much of the Sun.
#pragma once

#include <array>
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
  // The disc lies in slices one over the other: what stands near may hide the lower ones from a
  // height at which ground far away hides none, or the other way round.
  static constexpr int slices = 16;
  // Heights at one place, over the eye's plane: from there on one sees past all terrain along a ray
  // to the lower edge of the slice with that number; the last is the top of the disc.
  using Limits = std::array<double, slices + 1>;
  using KeptLimits = std::array<float, slices + 1>;
  // Nodes in rows towards the Sun.
  struct Level {
    double half_m = 0, cell_m = 0;
    std::vector<float> ground_m;  // over the eye's plane
    std::vector<KeptLimits> limits_m;
    std::vector<float> share;  // seen by the ground
  };
  struct Spot {
    const Level* level;
    std::size_t node;
    double right, up;  // shares of a cell
  };
  Level sampled(const Ground& ground, const Vec3& eye_S_m, double half_m) const;
  // The first column of a row that lies in the sector, or as many as there are.
  int first_seen(const Level& level, int row) const;
  void march(const Ground& ground, const Vec3& eye_S_m);
  // Ground of that height stands there; and one goes on by so much away from the Sun.
  void raise(Limits& limits_m, double ground_m) const;
  void lower(Limits& limits_m, double by_m) const;
  // Seen from that height.
  double share_of(double height_m, const Limits& limits_m, double cell_m) const;
  Limits at_edge(double across_m) const;
  void sweep(Level& level, const Level* coarser) const;
  // In the finest level that holds it, from a given one on; level is nullptr beyond all.
  Spot spot(double along_m, double across_m, std::size_t from = 0) const;
  static Limits unobstructed();
  static Limits limits_at(const Spot& spot);
  static double share_at(const Spot& spot);

  Vec3 up_S_, along_S_, across_S_;
  std::array<double, slices + 1> slopes_;  // of the rays
  std::array<double, slices> areas_;       // of the slices, as shares of the disc
  double radius_m_;                        // of the body
  GroundSector sector_;
  std::vector<Limits> edge_;   // of the last level, towards the Sun
  std::vector<Level> levels_;  // from fine to coarse
};

}  // namespace lsos
