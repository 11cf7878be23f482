// Dubins paths, for rovers that cannot turn on the spot: arcs and straight pieces, forwards only.
#pragma once

#include <array>
#include <optional>

#include "route/cost/route_cost.h"

namespace lsos {

// Planned turning radius, in units of the rover's tightest, so that the path follower can still
// steer back to its line.
inline constexpr double turning_margin = 1.1;

// Pose at the end of an arc of `length_m`; a positive curvature is to the left.
Pose2 along_arc(const Pose2& from, double curvature_1pm, double length_m);

// Accepted distance between an arc and the chords between its points. Smaller: more points, and a
// rover that follows the line slows down for corners that are rounding errors.
inline constexpr double chord_off_m = 0.03;

// Number of straight pieces of an arc.
int arc_pieces(double curvature_1pm, double length_m, double step_m);
// Points of an arc, evenly spaced, with both ends: `step_m` apart at most, or as far as chord_off_m
// allows where that is farther.
Line2 arc_line(const Pose2& from, double curvature_1pm, double length_m, double step_m);

// An arc of `radius_m` to one side and then a straight line to a place. Absent where the place lies
// within the circle.
std::optional<Line2> arc_and_straight(const Pose2& from, const Vec2& to_m, double radius_m,
                                      bool to_left, double step_m);

// Shortest path from pose to pose (Dubins 1957): three pieces, each an arc of `radius_m` or, in the
// middle, a straight line. Formulas of Shkel and Lumelsky (2001).
struct DubinsPiece {
  double curvature_1pm = 0;
  double length_m = 0;
};
using DubinsPath = std::array<DubinsPiece, 3>;
DubinsPath dubins_path(const Pose2& from, const Pose2& to, double radius_m);

// Two poses in the form that those formulas use, for several radii: their distance, and yaws
// relative to the line from one to the other.
struct PosePair {
  PosePair(const Pose2& from, const Pose2& to);

  double away_m, from_rad, to_rad;
  double sin_from, cos_from, sin_to, cos_to, cos_between;
};
// Absent where the path is not shorter than `most_m`.
std::optional<DubinsPath> dubins_path(const PosePair& poses, double radius_m, double most_m);

double length_m(const DubinsPath& path);
// Pose `so_far_m` along a path.
Pose2 along_dubins(const Pose2& from, const DubinsPath& path, double so_far_m);
// Points of a path, as arc_line() spaces them.
Line2 dubins_line(const Pose2& from, const DubinsPath& path, double step_m);

}  // namespace lsos
