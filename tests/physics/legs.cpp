#include "physics/legs.h"

#include <algorithm>
#include <limits>
#include <map>
#include <queue>

#include "base/random.h"
#include "driving/fillet.h"
#include "lua/host/mission_reader.h"
#include "mission/model/site.h"
#include "mission/routes/drive_cost_model.h"
#include "planet/ellipsoid.h"
#include "route/cost/route_cost.h"
#include "route/route_planner.h"

namespace lsos::test {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// A map about the straight line from the origin to the goal, with a node at the origin.
GroundMap map_about(const Ground& ground, const DriveCost& cost, const MapFrame& frame,
                    const Vec2& goal_m) {
  const double spacing_m = map_spacing_m(cost);
  const Vec2 aside_m = Vec2::Constant(spacing_m * std::ceil(25 / spacing_m));
  const Vec2 low_m = (goal_m.cwiseMin(0) / spacing_m).array().floor().matrix() * spacing_m;
  return {ground, frame, low_m - aside_m, goal_m.cwiseMax(0) + aside_m, spacing_m};
}

double lower_bound(RouteCost& costs, const Vec2& at_m, const Vec2& goal_m) {
  const double rise_m = costs.map().height_m(goal_m) - costs.map().height_m(at_m);
  const double bound = costs.least_per_metre() * (goal_m - at_m).norm() + costs.per_rise() * rise_m;
  return std::isnan(bound) ? 0 : 0.99 * std::max(0.0, bound);
}

}  // namespace

Geodetic SeededLeg::start() const {
  RandomStream random(mix_key(seed, "start"));
  if (terrain != "LunarSouthPole") return geodetic_from_degrees(10, 20);
  return geodetic_from_degrees(random.uniform(-180, 180), random.uniform(-89.5, -85));
}

std::unique_ptr<Ground> SeededLeg::ground() const {
  return ground_at(read_catalog("")->load_terrain(terrain, {}), *find_body("Moon"), start(), seed);
}

Vec3 SeededLeg::goal_S_m(const Ground& ground) const {
  RandomStream random(mix_key(seed, "goal"));
  const double yaw_rad = random.uniform(0, 2 * std::numbers::pi);
  Geodetic goal =
      ground.site().geodetic({length_m * std::cos(yaw_rad), length_m * std::sin(yaw_rad), 0});
  goal.height_m = ground.elevation_m(goal).value_or(0);
  return ground.site().p_S_m(goal);
}

DriveCost cost_of(const SeededLeg& leg, const Ground& ground) {
  const RoverModel model = read_catalog("")->load_rover(leg.rover, {});
  const double g_mps2 = gravity_mps2(*find_body("Moon"), ground.site().origin());
  const VehicleConfig vehicle = make_vehicle(model.spec, "", g_mps2);
  DriveCost cost =
      drive_cost(vehicle, ground.soils(), g_mps2, vehicle.cruise_speed_mps, model.limits);
  cost.load_w = load_w(model.power.loads, {});
  return cost;
}

double grid_cost(const Ground& ground, const DriveCost& cost, const Vec3& goal_S_m, RouteAim aim) {
  const StanceFinder finder(cost);
  const MapFrame frame(ground.site(), Vec3::Zero());
  const Vec2 goal_m = frame.at(goal_S_m);
  GroundMap map = map_about(ground, cost, frame, goal_m);
  RouteCost costs(map, finder, aim);
  costs.set_tight({{Vec2::Zero(), 2}, {goal_m, 2}});
  // Corners cost, so the state of a node includes the neighbour from which it is reached; 4 stands
  // for the start.
  constexpr int from_none = 4;
  const auto state = [&](int x, int y, int from) {
    return static_cast<std::size_t>((y * map.columns() + x) * 9 + from);
  };
  auto edge = [&, known = std::map<std::pair<std::size_t, int>, double>()](int x, int y,
                                                                           int step) mutable {
    const auto [found, is_new] = known.try_emplace({state(x, y, 0), step}, 0);
    if (is_new) {
      found->second =
          costs.straight(map.place_m(x, y), map.place_m(x + step % 3 - 1, y + step / 3 - 1));
    }
    return found->second;
  };
  std::vector<double> known(static_cast<std::size_t>(map.columns() * map.rows() * 9), infinite);
  using Entry = std::tuple<double, double, int, int, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const Vec2 start = -map.low_m() / map.spacing_m();
  const int x0 = static_cast<int>(std::lround(start.x()));
  const int y0 = static_cast<int>(std::lround(start.y()));
  known[state(x0, y0, from_none)] = 0;
  queue.push({lower_bound(costs, Vec2::Zero(), goal_m), 0, x0, y0, from_none});
  double best = infinite;
  while (!queue.empty()) {
    const auto [total, here, x, y, from] = queue.top();
    queue.pop();
    if (total >= best) break;
    if (here > known[state(x, y, from)]) continue;
    const Vec2 here_m = map.place_m(x, y);
    const Vec2 before_m = map.place_m(x - from % 3 + 1, y - from / 3 + 1);
    const auto corner = [&](const Vec2& to_m) {
      return from == from_none ? 0 : costs.corner(before_m, here_m, to_m);
    };
    if ((here_m - goal_m).cwiseAbs().maxCoeff() <= map.spacing_m()) {
      best = std::min(best, here + corner(goal_m) + costs.straight(here_m, goal_m));
    }
    for (int step = 0; step < 9; ++step) {
      const int u = x + step % 3 - 1, v = y + step / 3 - 1;
      if (step == from_none || u < 0 || v < 0 || u >= map.columns() || v >= map.rows()) continue;
      const Vec2 there_m = map.place_m(u, v);
      const double next = here + corner(there_m) + edge(x, y, step);
      if (!(next < known[state(u, v, step)])) continue;
      known[state(u, v, step)] = next;
      queue.push({next + lower_bound(costs, there_m, goal_m), next, u, v, step});
    }
  }
  return best;
}

double pose_cost(const Ground& ground, const DriveCost& cost, const LegRequest& request) {
  constexpr int headings = 36;
  constexpr double curvatures[] = {0, 1, -1, 0.3, -0.3, 0.13, -0.13};  // over 1 / least radius
  constexpr std::size_t kinds = std::size(curvatures);
  const StanceFinder finder(cost);
  const MapFrame frame(ground.site(), Vec3::Zero());
  const Vec2 goal_m = frame.at(request.goal_S_m);
  GroundMap map = map_about(ground, cost, frame, goal_m);
  RouteCost costs(map, finder, request.aim);
  costs.set_tight({{Vec2::Zero(), 2}, {goal_m, 2}});
  const double level_jpm = cost.soils.front().at(0).energy_jpm;
  const double per_j = request.aim == RouteAim::risk ? 1 / level_jpm : 1;
  const double step_m = 2 * map.spacing_m();
  // The cost of a pose depends on the turn that leads to it, because the rover slows down for
  // another one.
  const auto cell = [&](const Vec2& at_m, double yaw_rad, std::size_t kind) {
    const Vec2 place = (at_m - map.low_m()) / map.spacing_m();
    const double turn = yaw_rad / (2 * std::numbers::pi);
    const auto heading = static_cast<std::size_t>((turn - std::floor(turn)) * headings) % headings;
    const auto node =
        static_cast<std::size_t>(place.y()) * static_cast<std::size_t>(map.columns()) +
        static_cast<std::size_t>(place.x());
    return (node * headings + heading) * kinds + kind;
  };
  const auto share = [&](double curvature) {
    if (curvature == 0) return 1.0;
    const double radius_m = cost.turning_radius_min_m / std::abs(curvature);
    return arc_speed_mps(cost, radius_m) / cost.speed_mps;
  };
  struct Node {
    Vec2 at_m;
    double yaw_rad = 0;
    std::size_t kind = 0;
    std::int64_t before = -1;
    Line2 line;  // from the previous node
  };
  std::vector<Node> nodes{
      {Vec2::Zero(), std::numbers::pi / 2 - request.start_heading_rad, 0, -1, {Vec2::Zero()}}};
  std::vector<bool> is_closed(static_cast<std::size_t>(map.columns() * map.rows() * headings) *
                              kinds);
  using Entry = std::tuple<double, double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  queue.push({0, 0, 0});
  double best = infinite, least = infinite;
  while (!queue.empty()) {
    const auto [total, here, number] = queue.top();
    queue.pop();
    if (total >= least) break;
    const Vec2 here_m = nodes[number].at_m;
    const double yaw_rad = nodes[number].yaw_rad;
    const std::size_t before_kind = nodes[number].kind;
    const std::size_t now = cell(here_m, yaw_rad, before_kind);
    if (is_closed[now]) continue;
    is_closed[now] = true;
    const Vec2 off_m = goal_m - here_m;
    const double ahead_m = off_m.dot(Vec2(std::cos(yaw_rad), std::sin(yaw_rad)));
    if (off_m.norm() < 2 * step_m && ahead_m > 0.97 * off_m.norm()) {
      const double whole = here + costs.straight(here_m, goal_m);
      if (whole < least) {
        least = whole;
        std::vector<const Node*> chain;
        for (auto k = static_cast<std::int64_t>(number); k >= 0;
             k = nodes[static_cast<std::size_t>(k)].before) {
          chain.push_back(&nodes[static_cast<std::size_t>(k)]);
        }
        Line2 line;
        for (auto node = chain.rbegin(); node != chain.rend(); ++node) {
          line.insert(line.end(), (*node)->line.begin(), (*node)->line.end());
        }
        line.push_back(goal_m);
        best = std::min(best, costs.of(line).cost);
      }
    }
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      // The step consists of short straight pieces, as an arc is driven.
      constexpr int pieces = 4;
      Node next{here_m, yaw_rad, kind, static_cast<std::int64_t>(number), {}};
      const double by_rad = curvatures[kind] * step_m / pieces / cost.turning_radius_min_m;
      double edge = 0;
      for (int k = 0; k < pieces; ++k) {
        const double to_rad = next.yaw_rad + by_rad / 2;
        const Vec2 next_m = next.at_m + step_m / pieces * Vec2(std::cos(to_rad), std::sin(to_rad));
        edge += costs.straight(next.at_m, next_m);
        next.at_m = next_m;
        next.yaw_rad += by_rad;
        next.line.push_back(next_m);
      }
      if (!std::isfinite(edge) || std::isnan(map.height_m(next.at_m))) continue;
      if (is_closed[cell(next.at_m, next.yaw_rad, kind)]) continue;
      const double was = share(curvatures[before_kind]), is = share(curvatures[kind]);
      const double longer_s = step_m * (1 / is - 1) / cost.speed_mps;
      edge += per_j * (cost.slow_j * std::max(0.0, was * was - is * is) + cost.load_w * longer_s +
                       cost.arc_drag_jmprad * std::pow(is, 4) * std::abs(by_rad) * pieces *
                           std::abs(curvatures[kind]) / cost.turning_radius_min_m);
      const double left = lower_bound(costs, next.at_m, goal_m);
      queue.push({here + edge + left, here + edge, nodes.size()});
      nodes.push_back(std::move(next));
    }
  }
  return best;
}

}  // namespace lsos::test
