#include "mission/routes/drawn_leg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "route/cost/explain.h"
#include "route/cost/stance.h"
#include "route/cost/standing_obstacles.h"

namespace lsos {

namespace {

constexpr double longest_m = 100e3;
// Length of a leg covered by one map of the ground.
constexpr double piece_m = 64;
// Shortest stretch that counts as steep: a wheel that steps over an edge is no slope.
constexpr double steep_least_m = 1;

bool is_too_steep(Hazard hazard) {
  return hazard == Hazard::slope || hazard == Hazard::climb || hazard == Hazard::slide;
}

// Slope in excess of what the rover may or can climb.
double slope_beyond_rad(const Stance& stance, const DriveCost& cost) {
  const double climb_rad = climb_max_rad(cost.soils[static_cast<std::size_t>(stance.soil)]);
  return stance.slope_rad - std::min(cost.limits.slope_max_rad, climb_rad);
}

class DrawnLeg {
 public:
  DrawnLeg(const Ground& ground, const DriveCost& cost, const Obstacles& obstacles)
      : ground_(ground), finder_(cost), obstacles_(obstacles) {}

  DrawnLegFindings look(const Vec3& from_S_m, const Vec3& to_S_m) {
    const double length_m = (to_S_m - from_S_m).norm();
    if (length_m < 1e-3 || length_m > longest_m) return {};
    const int pieces = static_cast<int>(std::ceil(length_m / piece_m));
    for (int k = 0; k < pieces; ++k) {
      const auto at_S_m = [&](int i) -> Vec3 {
        return from_S_m + (to_S_m - from_S_m) * (static_cast<double>(i) / pieces);
      };
      examine_piece(at_S_m(k), at_S_m(k + 1), length_m * k / pieces);
    }
    end_steep(length_m);
    return found_;
  }

 private:
  void examine_piece(const Vec3& from_S_m, const Vec3& to_S_m, double begin_m) {
    const MapFrame frame(ground_.site(), from_S_m);
    const Vec2 to_m = frame.at(to_S_m);
    const double spacing_m = map_spacing_m(finder_.cost());
    const Vec2 aside_m = Vec2::Constant(finder_.reach_m() + 3 * spacing_m);
    GroundMap map(ground_, frame, to_m.cwiseMin(0) - aside_m, to_m.cwiseMax(0) + aside_m,
                  spacing_m);
    const Vec2 ahead = to_m.normalized();
    const int steps = std::max(1, static_cast<int>(std::ceil(to_m.norm() / spacing_m)));
    for (int i = 0; i <= steps; ++i) {
      const Vec2 at_m = to_m * (static_cast<double>(i) / steps);
      examine(map, at_m, ahead, begin_m + at_m.norm());
    }
  }

  void examine(GroundMap& map, const Vec2& at_m, const Vec2& ahead, double along_m) {
    const Stance stance = finder_.at(map, at_m, ahead);
    const Vec3 p_S_m = map.frame().p_S_m(at_m);
    if (!stance.is_on_ground) {
      if (!found_.no_ground) {
        found_.no_ground = {"leads where the terrain is not known", along_m, p_S_m};
      }
      return end_steep(along_m);
    }
    find_obstacle(map.frame(), at_m, ahead, along_m);
    const Hazard found = hazard(stance, finder_.cost());
    if (!is_too_steep(found)) return end_steep(along_m);
    if (!steep_begin_m_) steep_begin_m_ = along_m;
    const double beyond_rad = slope_beyond_rad(stance, finder_.cost());
    if (stretch_ && beyond_rad <= stretch_->beyond_rad) return;
    stretch_ = {"leads " + describe(found, stance, finder_.cost()), along_m, p_S_m, beyond_rad};
  }

  // Ends a stretch of steep ground.
  void end_steep(double along_m) {
    if (!steep_begin_m_) return;
    const bool counts = along_m - *steep_begin_m_ >= steep_least_m;
    if (counts && (!found_.steep || stretch_->beyond_rad > found_.steep->beyond_rad)) {
      found_.steep = stretch_;
    }
    steep_begin_m_.reset();
    stretch_.reset();
  }

  void find_obstacle(const MapFrame& frame, const Vec2& at_m, const Vec2& ahead, double along_m) {
    if (found_.occupied) return;
    const Footprint rover = moved(obstacles_.rover_at_rest, at_m, ahead);
    const StandingObstacles standing(obstacles_, frame);
    for (std::size_t i = 0; i < standing.footprints().size(); ++i) {
      if (!overlap(rover, standing.footprints()[i])) continue;
      found_.occupied = {fmt::format("leads through '{}'", standing.id(i)), along_m,
                         frame.p_S_m(at_m)};
      return;
    }
  }

  const Ground& ground_;
  StanceFinder finder_;
  const Obstacles& obstacles_;
  DrawnLegFindings found_;
  std::optional<DrawnFinding> stretch_;  // present stretch of steep ground, and where it began
  std::optional<double> steep_begin_m_;
};

}  // namespace

DrawnLegFindings examine_leg(const Ground& ground, const DriveCost& cost,
                             const Obstacles& obstacles, const Vec3& from_S_m, const Vec3& to_S_m) {
  return DrawnLeg(ground, cost, obstacles).look(from_S_m, to_S_m);
}

double miss_distance_m(const Vec2& ahead, const Vec2& offset_m, double radius_m) {
  const double forward_m = ahead.dot(offset_m);
  const double aside_m = std::abs(ahead.x() * offset_m.y() - ahead.y() * offset_m.x());
  return radius_m - std::hypot(forward_m, aside_m - radius_m);
}

}  // namespace lsos
