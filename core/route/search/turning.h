// Ways of a rover that cannot turn on the spot: arcs and straight pieces, ahead only.
#pragma once

#include <array>
#include <optional>

#include "route/cost/leg_cost.h"

namespace lsos {

// Such a rover is planned with turns this much wider than its tightest, so that what follows the
// line can still steer back to it.
inline constexpr double turning_margin = 1.1;

// An arc of `length_m`, to the left with a positive curvature; the pose that it ends in.
Pose2 along_arc(const Pose2& from, double curvature_1pm, double length_m);

// Points of arcs lie so near to each other that the chords between them are no farther off it.
// With more of them a rover that follows the line would slow down for corners that rounding makes.
inline constexpr double chord_off_m = 0.03;

// Of so many straight pieces.
int arc_pieces(double curvature_1pm, double length_m, double step_m);
// Its points, evenly, with both ends: `step_m` apart at most, or as far as chord_off_m lets them
// be.
Line2 arc_line(const Pose2& from, double curvature_1pm, double length_m, double step_m);

// An arc of `radius_m` to one side and then straight to a place. Absent where the place lies within
// the circle.
std::optional<Line2> arc_and_straight(const Pose2& from, const Vec2& to_m, double radius_m,
                                      bool to_left, double step_m);

// The shortest way from pose to pose (Dubins 1957): three pieces, arcs of `radius_m` but for a
// straight one in the middle. By the formulas of Shkel and Lumelsky (2001).
struct TurningPiece {
  double curvature_1pm = 0;
  double length_m = 0;
};
using TurningWay = std::array<TurningPiece, 3>;
TurningWay shortest_turns(const Pose2& from, const Pose2& to, double radius_m);

// Two poses as those formulas take them, for several radii: how far apart, and yaws to the line
// from one to the other.
struct PosePair {
  PosePair(const Pose2& from, const Pose2& to);

  double away_m, from_rad, to_rad;
  double sin_from, cos_from, sin_to, cos_to, cos_between;
};
// Absent where it is not shorter than that.
std::optional<TurningWay> shortest_turns(const PosePair& poses, double radius_m, double most_m);

double length_m(const TurningWay& way);
// The pose so far along it.
Pose2 along_turns(const Pose2& from, const TurningWay& way, double so_far_m);
// Its points as those of its arcs.
Line2 turns_line(const Pose2& from, const TurningWay& way, double step_m);

}  // namespace lsos
