#include "driving/driving_line.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/segment.h"

namespace lsos {

namespace {

constexpr double same_point_m = 0.01;
constexpr double straight_rad = 0.01;  // bends below this need no arc
constexpr double arc_step_rad = 0.1;

class LineBuilder {
 public:
  LineBuilder(const DrivingLimits& limits, const Vec2& start) : limits_(limits), at_(start) {}

  void go_to(const Vec2& point, double curvature_1pm) {
    const Vec2 step_m = point - at_;
    const double length_m = step_m.norm();
    if (length_m < 1e-9) return;
    const double speed_mps =
        curvature_1pm == 0 ? limits_.speed_mps : arc_speed_mps(1 / std::abs(curvature_1pm));
    pieces_.push_back({at_, step_m / length_m, length_m, along_m_, curvature_1pm, speed_mps,
                       limits_.speed_mps, false});
    along_m_ += length_m;
    at_ = point;
  }

  // Continues to the corner, either by a fillet or to the corner point itself. There a rover that
  // can turn on the spot stops; another one slows down and turns as tightly as it can.
  void round_corner(const Vec2& corner, const Vec2& next) {
    const Vec2 in = (corner - at_).normalized(), out = (next - corner).normalized();
    const double bend = bend_rad(in, out), half = std::abs(bend) / 2;
    if (2 * half < straight_rad) return go_to(corner, 0);
    // This corner may use half of the next side; the rest belongs to the next corner.
    const double before_m = (corner - at_).norm(), after_m = (next - corner).norm();
    double radius_m =
        fillet_radius_m(2 * half, std::min(before_m, 0.5 * after_m), limits_.corner_offset_m);
    if (radius_m < limits_.radius_min_m) {
      const bool has_room = limits_.radius_min_m * std::tan(half) <= std::min(before_m, after_m);
      if (limits_.can_turn_on_spot || !has_room) {
        go_to(corner, 0);
        if (pieces_.empty()) return;
        pieces_.back().ends_in_stop = limits_.can_turn_on_spot;
        pieces_.back().end_speed_mps = arc_speed_mps(limits_.radius_min_m);
        return;
      }
      radius_m = limits_.radius_min_m;
    }
    const double tangent_m = radius_m * std::tan(half);
    go_to(corner - in * tangent_m, 0);
    const double curvature_1pm = (bend > 0 ? 1 : -1) / radius_m;
    const Vec2 left(-in.y(), in.x());
    const Vec2 begin = corner - in * tangent_m, centre = begin + left / curvature_1pm;
    const int steps = static_cast<int>(std::ceil(std::abs(bend) / arc_step_rad));
    for (int i = 1; i <= steps; ++i) {
      const Eigen::Rotation2Dd turn(bend * i / steps);
      go_to(centre + turn * (begin - centre), curvature_1pm);
    }
  }

  std::vector<DrivingPiece> finished() {
    // Backward pass: each end speed is low enough to reach the next one's by decelerating.
    double end_mps = 0;
    for (auto piece = pieces_.rbegin(); piece != pieces_.rend(); ++piece) {
      if (piece->ends_in_stop) end_mps = 0;
      piece->end_speed_mps = std::min({end_mps, piece->speed_max_mps, piece->end_speed_mps});
      end_mps = std::min(piece->speed_max_mps,
                         std::sqrt(piece->end_speed_mps * piece->end_speed_mps +
                                   2 * limits_.acceleration_mps2 * piece->length_m));
    }
    if (!pieces_.empty()) pieces_.back().ends_in_stop = true;
    return std::move(pieces_);
  }

 private:
  double arc_speed_mps(double radius_m) const {
    return lsos::arc_speed_mps(radius_m, limits_.speed_mps, limits_.lateral_mps2,
                               limits_.steering_m);
  }

  DrivingLimits limits_;
  Vec2 at_;
  double along_m_ = 0;
  std::vector<DrivingPiece> pieces_;
};

// The line through waypoints that are driven in one gear.
std::vector<DrivingPiece> stretch(std::span<const Vec2> waypoints_S_m,
                                  const DrivingLimits& limits) {
  std::vector<Vec2> points;
  for (const Vec2& p : waypoints_S_m) {
    if (points.empty() || (p - points.back()).norm() > same_point_m) points.push_back(p);
  }
  if (points.size() < 2) return {};
  LineBuilder builder(limits, points.front());
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    builder.round_corner(points[i], points[i + 1]);
  builder.go_to(points.back(), 0);
  return builder.finished();
}

}  // namespace

std::vector<DrivingPiece> driving_line(const std::vector<Vec2>& waypoints_S_m,
                                       const DrivingLimits& limits,
                                       const std::vector<std::size_t>& gear_changes) {
  if (gear_changes.empty()) return stretch(waypoints_S_m, limits);
  std::vector<DrivingPiece> line;
  bool is_backward = false;
  double begin_m = 0;
  std::size_t first = 0;
  for (std::size_t k = 0; k <= gear_changes.size(); ++k) {
    const std::size_t last = k < gear_changes.size() ? gear_changes[k] : waypoints_S_m.size() - 1;
    for (DrivingPiece piece :
         stretch(std::span(waypoints_S_m).subspan(first, last - first + 1), limits)) {
      piece.begin_m += begin_m;
      piece.is_backward = is_backward;
      line.push_back(piece);
    }
    if (!line.empty()) begin_m = line.back().begin_m + line.back().length_m;
    is_backward = !is_backward;
    first = last;
  }
  return line;
}

}  // namespace lsos
