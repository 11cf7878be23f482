#include "route/search/dubins_path.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <utility>

namespace lsos {

namespace {

Vec2 left_of(const Vec2& ahead) { return {-ahead.y(), ahead.x()}; }

// Angle in 0 .. 2 pi; a full turn but for rounding is 0.
double full_turn(double angle_rad) {
  constexpr double rounding_rad = 1e-7;
  const double turned =
      angle_rad - 2 * std::numbers::pi * std::floor(angle_rad / (2 * std::numbers::pi));
  return turned > 2 * std::numbers::pi - rounding_rad ? 0 : turned;
}

// Dubins word: left turn 1, right turn -1, straight 0; lengths in radii.
struct DubinsWord {
  double turns[3];
  double t, p, q;
};

// Keeps the shortest of the words offered.
struct Shortest {
  double least;  // in radii
  std::optional<DubinsWord> word;

  void offer(const DubinsWord& other) {
    const double sum = other.t + other.p + other.q;
    if (sum >= least) return;
    least = sum;
    word = other;
  }
};

// Shortest of all words; d: distance in radii. Absent where none is shorter than `most`. A lower
// bound of each word is tested first: most need no arc tangent.
std::optional<DubinsWord> shortest_dubins_word(const PosePair& poses, double d, double most) {
  const double alpha = poses.from_rad, beta = poses.to_rad;
  const double sa = poses.sin_from, sb = poses.sin_to, ca = poses.cos_from, cb = poses.cos_to,
               cab = poses.cos_between;
  Shortest shortest{most, {}};
  // Where both poses are on one circle, the straight piece is 0 but for rounding and has no
  // direction. If shorter than `same` it is left out, and the lower bound of its word is `same`
  // less.
  constexpr double rounding = 1e-9, same = 1e-6;
  const auto straight = [&](double first, double last, double p_squared, auto&& ends) {
    if (p_squared < -rounding) return;
    const double p = std::sqrt(std::max(0.0, p_squared));
    const double turned = first == last ? full_turn(first * (beta - alpha)) : 0;
    if (p + turned - same >= shortest.least) return;
    if (first == last && p < same) {
      shortest.offer({{first, 0, last}, turned, 0, 0});
      return;
    }
    const auto [t, q] = ends(p);
    shortest.offer({{first, 0, last}, full_turn(t), p, full_turn(q)});
  };
  using Ends = std::pair<double, double>;
  straight(1, 1, 2 + d * d - 2 * cab + 2 * d * (sa - sb), [&](double) {
    const double turn = std::atan2(cb - ca, d + sa - sb);
    return Ends(turn - alpha, beta - turn);
  });
  straight(-1, -1, 2 + d * d - 2 * cab + 2 * d * (sb - sa), [&](double) {
    const double turn = std::atan2(ca - cb, d - sa + sb);
    return Ends(alpha - turn, turn - beta);
  });
  straight(1, -1, d * d - 2 + 2 * cab + 2 * d * (sa + sb), [&](double p) {
    const double turn = std::atan2(-ca - cb, d + sa + sb) - std::atan2(-2.0, p);
    return Ends(turn - alpha, turn - beta);
  });
  straight(-1, 1, d * d - 2 + 2 * cab - 2 * d * (sa + sb), [&](double p) {
    const double turn = std::atan2(ca + cb, d - sa - sb) - std::atan2(2.0, p);
    return Ends(alpha - turn, beta - turn);
  });
  const auto three_arcs = [&](double first) {
    // Right, left, right with first = -1; its mirror image with first = 1.
    const double cosine = (6 - d * d + 2 * cab - first * 2 * d * (sa - sb)) / 8;
    if (std::abs(cosine) > 1 || shortest.least <= std::numbers::pi) return;
    const double p = 2 * std::numbers::pi - std::acos(cosine);
    const double turn = std::atan2(ca - cb, d + first * (sa - sb));
    const double t = full_turn(-first * (alpha + first * turn) + p / 2);
    const double q = full_turn(-first * (alpha - beta) - t + p);
    shortest.offer({{first, -first, first}, t, p, q});
  };
  three_arcs(-1);
  three_arcs(1);
  return shortest.word;
}

}  // namespace

Pose2 along_arc(const Pose2& from, double curvature_1pm, double length_m) {
  constexpr double straight_1pm = 1e-9;
  if (std::abs(curvature_1pm) < straight_1pm) {
    return {from.at_m + length_m * from.ahead(), from.yaw_rad};
  }
  const double yaw_rad = from.yaw_rad + curvature_1pm * length_m;
  const Vec2 chord = {std::sin(yaw_rad) - std::sin(from.yaw_rad),
                      std::cos(from.yaw_rad) - std::cos(yaw_rad)};
  return {from.at_m + chord / curvature_1pm, yaw_rad};
}

int arc_pieces(double curvature_1pm, double length_m, double step_m) {
  // A straight line needs its ends only.
  const double chord_m = std::sqrt(8 * chord_off_m / std::max(std::abs(curvature_1pm), 1e-12));
  return std::max(1, static_cast<int>(std::ceil(length_m / std::max(step_m, chord_m) - 1e-9)));
}

Line2 arc_line(const Pose2& from, double curvature_1pm, double length_m, double step_m) {
  const int pieces = arc_pieces(curvature_1pm, length_m, step_m);
  Line2 line{from.at_m};
  for (int k = 1; k <= pieces; ++k) {
    line.push_back(along_arc(from, curvature_1pm, length_m * k / pieces).at_m);
  }
  return line;
}

std::optional<Line2> arc_and_straight(const Pose2& from, const Vec2& to_m, double radius_m,
                                      bool to_left, double step_m) {
  const double side = to_left ? 1 : -1;
  const Vec2 center_m = from.at_m + side * radius_m * left_of(from.ahead());
  const Vec2 delta_m = to_m - center_m;
  const double away_m = delta_m.norm();
  if (away_m < radius_m) return std::nullopt;
  // The tangent through the place touches the circle where the radius makes this angle with
  // `delta_m`.
  const double opening_rad = std::acos(radius_m / away_m);
  const double leave_rad = std::atan2(delta_m.y(), delta_m.x()) - side * opening_rad;
  const double begin_rad = std::atan2(from.at_m.y() - center_m.y(), from.at_m.x() - center_m.x());
  double turn_rad = std::remainder(side * (leave_rad - begin_rad), 2 * std::numbers::pi);
  constexpr double none_rad = 1e-9;
  if (turn_rad < -none_rad) turn_rad += 2 * std::numbers::pi;
  turn_rad = std::max(0.0, turn_rad);
  Line2 line = arc_line(from, side / radius_m, turn_rad * radius_m, step_m);
  line.push_back(to_m);
  return line;
}

PosePair::PosePair(const Pose2& from, const Pose2& to) {
  const Vec2 delta_m = to.at_m - from.at_m;
  away_m = delta_m.norm();
  const double bearing_rad = away_m > 0 ? std::atan2(delta_m.y(), delta_m.x()) : 0;
  from_rad = from.yaw_rad - bearing_rad;
  to_rad = to.yaw_rad - bearing_rad;
  sin_from = std::sin(from_rad);
  cos_from = std::cos(from_rad);
  sin_to = std::sin(to_rad);
  cos_to = std::cos(to_rad);
  cos_between = cos_from * cos_to + sin_from * sin_to;
}

DubinsPath dubins_path(const Pose2& from, const Pose2& to, double radius_m) {
  constexpr double any_m = std::numeric_limits<double>::infinity();
  return dubins_path(PosePair(from, to), radius_m, any_m).value_or(DubinsPath{});
}

std::optional<DubinsPath> dubins_path(const PosePair& poses, double radius_m, double most_m) {
  const auto word = shortest_dubins_word(poses, poses.away_m / radius_m, most_m / radius_m);
  if (!word) return std::nullopt;
  return DubinsPath{{{word->turns[0] / radius_m, word->t * radius_m},
                     {word->turns[1] / radius_m, word->p * radius_m},
                     {word->turns[2] / radius_m, word->q * radius_m}}};
}

double length_m(const DubinsPath& path) {
  return path[0].length_m + path[1].length_m + path[2].length_m;
}

Pose2 along_dubins(const Pose2& from, const DubinsPath& path, double so_far_m) {
  Pose2 at = from;
  for (const DubinsPiece& piece : path) {
    const double here_m = std::clamp(so_far_m, 0.0, piece.length_m);
    at = along_arc(at, piece.curvature_1pm, here_m);
    so_far_m -= here_m;
  }
  return at;
}

Line2 dubins_line(const Pose2& from, const DubinsPath& path, double step_m) {
  Line2 line{from.at_m};
  Pose2 at = from;
  for (const DubinsPiece& piece : path) {
    constexpr double none_m = 1e-9;
    if (piece.length_m < none_m) continue;
    const Line2 more = arc_line(at, piece.curvature_1pm, piece.length_m, step_m);
    line.insert(line.end(), more.begin() + 1, more.end());
    at = along_arc(at, piece.curvature_1pm, piece.length_m);
  }
  return line;
}

}  // namespace lsos
