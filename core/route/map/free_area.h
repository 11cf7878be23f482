// The ground within a polygon and outside its holes, on the plane: which parts of a straight line
// lie in it, and the shortest path within it that keeps a distance from the holes.
//
// The path follows a visibility graph (Lozano-Perez and Wesley 1979, An algorithm for planning
// collision-free paths among polyhedral obstacles): straight lines between corners that see each
// other. It turns where two tangents meet that touch a circle around the corner, whose radius is
// the margin.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/polygon.h"

namespace lsos {

class FreeArea {
 public:
  FreeArea(Ring outline, std::vector<Ring> holes);

  // Parts of a straight line that lie inside the outline and at least `margin_m` from each hole:
  // begin and end as shares of its length, ascending.
  std::vector<std::pair<double, double>> parts(const Vec2& from_m, const Vec2& to_m,
                                               double margin_m) const;

  struct Path {
    std::vector<Vec2> points_m;  // after `from_m`; the last is `to_m`
    double margin_m = 0;         // kept from the holes where neither end is nearer
    bool is_given_up = false;    // too many corners to search: no points
  };
  // Shortest path that stays inside the outline and keeps `margin_m` from the holes. Where there is
  // none it keeps half of that, and so on down to a sixteenth. It keeps as much from corners of the
  // outline, or next to nothing where that leads nowhere. Where an end is nearer to a hole than the
  // margin, the path keeps that end's distance from the hole. A path that begins outside the
  // outline may stay as far outside; one that begins in a hole leaves it at the nearest place.
  // Absent where there is none.
  std::optional<Path> path(const Vec2& from_m, const Vec2& to_m, double margin_m) const;

  // Number of sides of the outline and the holes.
  std::size_t size() const;

 private:
  struct Limits {
    double margin_m = 0;            // wanted from holes
    double outline_margin_m = 0;    // from its corners, not from its sides
    std::vector<double> margins_m;  // from each hole
    double slack_m = 0;             // allowed outside the outline
    bool are_full = true;           // both ends lie inside and keep the margin
  };
  Limits limits(const Vec2& from_m, const Vec2& to_m, double margin_m) const;
  double outside_m(const Vec2& p_m) const;
  bool is_inside(const Vec2& p_m, double slack_m) const;
  bool can_turn_at(const Vec2& p_m, const Limits& limits) const;
  bool is_free(const Vec2& a_m, const Vec2& b_m, const Limits& limits) const;
  std::optional<Vec2> exit(const Vec2& p_m, double margin_m) const;
  struct Turn {
    Vec2 at_m;
    Vec2 in, out;  // directions of the sides that meet there, unit; 0: any
  };
  static bool is_tangent(const Turn& turn, const Vec2& delta_m);
  std::vector<Turn> corners(const Limits& limits) const;
  std::optional<Path> search(const Vec2& from_m, const Vec2& to_m, const Limits& limits) const;

  Ring outline_;             // counter-clockwise
  std::vector<Ring> holes_;  // clockwise: the free ground lies to the left of every side
  std::vector<Eigen::AlignedBox2d> boxes_;  // round the holes
};

}  // namespace lsos
