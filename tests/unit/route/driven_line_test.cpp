// Planned time of a line against that of the line that the path follower drives: the planner adds
// up pieces and corners, the follower carries one speed along the whole.
#include <gtest/gtest.h>

#include <random>

#include "driving/driving_line.h"
#include "route/cost/route_cost.h"
#include "route/search/dubins_path.h"
#include "unit/route/test_rover.h"

namespace lsos::test {
namespace {

constexpr double acceleration_mps2 = 0.2;

DriveCost driven_rover(bool can_turn_on_spot) {
  DriveCost cost = simple_rover();
  cost.can_turn_on_spot = can_turn_on_spot;
  cost.acceleration_mps2 = acceleration_mps2;
  cost.stop_s = cost.speed_mps / acceleration_mps2;
  cost.turning_radius_min_m = 2;
  cost.turn_sprad = 5;
  cost.load_w = 1;
  return cost;
}

// Time from rest to rest along the driving line, speeding up and slowing down at the acceleration.
double driven_s(const Line2& line, const DriveCost& cost) {
  DrivingLimits limits;
  limits.speed_mps = cost.speed_mps;
  limits.acceleration_mps2 = limits.lateral_mps2 = cost.acceleration_mps2;
  limits.radius_min_m = cost.turning_radius_min_m;
  limits.can_turn_on_spot = cost.can_turn_on_spot;
  double time_s = 0, from_mps = 0;
  const std::vector<DrivingPiece> legs = driving_line(line, limits);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const DrivingPiece& leg = legs[i];
    const double gain = 2 * cost.acceleration_mps2 * leg.length_m, from2 = from_mps * from_mps;
    const double to_mps = std::min(leg.end_speed_mps, std::sqrt(from2 + gain));
    const double to2 = to_mps * to_mps;
    const double peak_mps = std::min(leg.speed_max_mps, std::sqrt((from2 + to2 + gain) / 2));
    const double changing_m = (2 * peak_mps * peak_mps - from2 - to2) / 2 / cost.acceleration_mps2;
    time_s += (2 * peak_mps - from_mps - to_mps) / cost.acceleration_mps2 +
              (leg.length_m - changing_m) / peak_mps;
    from_mps = to_mps;
    if (!leg.ends_in_stop || i + 1 == legs.size()) continue;
    const double bend_rad = std::acos(std::clamp(leg.along_S.dot(legs[i + 1].along_S), -1.0, 1.0));
    time_s += cost.turn_sprad * bend_rad;
  }
  return time_s;
}

struct DrivenOnLevel {
  explicit DrivenOnLevel(const DriveCost& of) : cost(of) {}

  Site site{{}};
  DriveCost cost;
  GroundMap map{site.ground(),
                MapFrame(site.ground().site(), {0, 0, 0}),
                {-600, -600},
                {600, 600},
                map_spacing_m(cost)};
  StanceFinder finder{cost};
  RouteCost costs{map, finder, RouteAim::energy};
};

// Differences of planned from driven time over many lines, as shares.
struct Agreement {
  double worst = 0, sum = 0;
  int count = 0;

  void add(double planned_s, double driven_s) {
    const double off = planned_s / driven_s - 1;
    worst = std::max(worst, std::abs(off));
    sum += off;
    ++count;
  }
  double mean() const { return sum / count; }
};

// The planner's summary leaves out setting off at the start and stopping at the end.
double planned_s(DrivenOnLevel& rover, const Line2& line) {
  return rover.costs.of(line).duration_s + rover.cost.stop_s;
}

TEST(DrivenLine, takes_as_long_as_planned_with_turns_on_the_spot) {
  DrivenOnLevel rover(driven_rover(true));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> length_m(4, 30), sharp_rad(-2, 2), gentle_rad(-0.3, 0.3);
  Agreement agreement;
  for (int k = 0; k < 200; ++k) {
    Line2 line{{0, 0}};
    double yaw_rad = 0;
    for (int i = 0; i < 12; ++i) {
      line.push_back(line.back() + length_m(random) * Vec2(std::cos(yaw_rad), std::sin(yaw_rad)));
      yaw_rad += i % 3 == 0 ? sharp_rad(random) : gentle_rad(random);
    }
    agreement.add(planned_s(rover, line), driven_s(line, rover.cost));
  }
  EXPECT_LT(agreement.worst, 0.002);
}

// Arcs of polylines: the planner takes each bend of the points for an arc by itself, while the
// driving line lays its fillets one after the other.
TEST(DrivenLine, takes_as_long_as_planned_with_arcs) {
  DrivenOnLevel rover(driven_rover(false));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> straight_m(0, 25), radius_m(2, 12), bend_rad(0.2, 2);
  Agreement agreement;
  for (int k = 0; k < 200; ++k) {
    Line2 line{{0, 0}};
    Pose2 at;
    for (int i = 0; i < 5; ++i) {
      const double radius = radius_m(random), bend = bend_rad(random);
      const double side = random() % 2 == 0 ? 1 : -1;
      const Line2 arc = arc_line(at, side / radius, radius * bend, 0.5);
      line.insert(line.end(), arc.begin() + 1, arc.end());
      at.at_m = arc.back();
      at.yaw_rad += side * bend;
      at.at_m += straight_m(random) * at.ahead();
      line.push_back(at.at_m);
    }
    agreement.add(planned_s(rover, line), driven_s(line, rover.cost));
  }
  EXPECT_LT(agreement.worst, 0.05);
  EXPECT_LT(std::abs(agreement.mean()), 0.015);
}

}  // namespace
}  // namespace lsos::test
