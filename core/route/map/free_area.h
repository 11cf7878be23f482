// The ground within a polygon and outside its holes, on the plane: which parts of a straight line
// lie in it, and the shortest path within it that keeps a distance from the holes.
//
// The path goes along a visibility graph (Lozano-Perez and Wesley 1979, An algorithm for planning
// collision-free paths among polyhedral obstacles): straight lines between corners that see each
// other. A corner stands off what it goes round, two lines tangent to the circle of the margin.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/polygon.h"

namespace lsos {

class FreeArea {
 public:
  FreeArea(Ring outline, std::vector<Ring> holes);

  // Where the straight line lies inside the outline and at least `margin_m` from each hole: from
  // and to as shares of its length, ascending.
  std::vector<std::pair<double, double>> parts(const Vec2& from_m, const Vec2& to_m,
                                               double margin_m) const;

  struct Path {
    std::vector<Vec2> points_m;  // after `from`, the last is `to`
    double margin_m = 0;         // that it keeps from the holes where neither end is nearer
    bool is_given_up = false;    // too many corners to find one: no points
  };
  // The shortest path that stays inside the outline and keeps `margin_m` from the holes. Where
  // there is none it keeps half of that, and so on down to a sixteenth. It goes round corners of
  // the outline by as much, or right at them where that leads nowhere. From a hole that an end is
  // nearer to it keeps what that end does. A path that begins outside the outline may stay as far
  // outside; one that begins in a hole leaves it where that is nearest. Absent: there is none.
  std::optional<Path> path(const Vec2& from_m, const Vec2& to_m, double margin_m) const;

  // Sides of the outline and the holes.
  std::size_t size() const;

 private:
  struct Limits {
    double margin_m = 0;            // that is wanted from holes
    double outline_margin_m = 0;    // at its corners, not along its sides
    std::vector<double> margins_m;  // from each hole
    double slack_m = 0;             // outside the outline
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
  static bool is_tangent(const Turn& turn, const Vec2& way_m);
  std::vector<Turn> corners(const Limits& limits) const;
  std::optional<Path> search(const Vec2& from_m, const Vec2& to_m, const Limits& limits) const;

  Ring outline_;             // counter-clockwise
  std::vector<Ring> holes_;  // clockwise: the free ground lies to the left of every side
  std::vector<Eigen::AlignedBox2d> boxes_;  // round the holes
};

}  // namespace lsos
