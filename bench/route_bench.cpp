// Time of planning a leg, per square kilometre of corridor and per million nodes of its map (a
// square kilometre at 1 m), as the mean of seeded legs. It is measured for the whole plan, on maps
// whose terrain tiles are cached, over craters and over a raster of rough ground; and for
// comparison for the plain A* of the quality test, on legs of the same corridor.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "physics/legs.h"
#include "route/cost/stance.h"
#include "route/route_planner.h"

namespace {

struct Leg {
  std::unique_ptr<lsos::Ground> ground;
  lsos::DriveCost cost;
  lsos::LegRequest request;
};

// The first `count` legs by seed that have a route, each planned once so that their tiles are
// cached.
const std::vector<Leg>& legs(const std::string& rover, const std::string& terrain, int length_m,
                             std::size_t count) {
  static std::map<std::tuple<std::string, std::string, int, std::size_t>, std::vector<Leg>> known;
  const auto [found, is_new] = known.try_emplace({rover, terrain, length_m, count});
  std::vector<Leg>& legs = found->second;
  for (std::uint64_t seed = 1; is_new && legs.size() < count; ++seed) {
    const lsos::test::SeededLeg seeded{rover, terrain, seed, static_cast<double>(length_m)};
    Leg leg{seeded.ground(), {}, {}};
    leg.cost = cost_of(seeded, *leg.ground);
    leg.request.goal_S_m = seeded.goal_S_m(*leg.ground);
    // independent of the direction of the goal
    leg.request.start_heading_rad = 0.1 * static_cast<double>(seed);
    leg.request.seed = seed;
    if (plan_leg(*leg.ground, leg.cost, leg.request).is_found()) legs.push_back(std::move(leg));
  }
  return legs;
}

// Area of the first corridor of plan_leg(), along the leg.
double corridor_m2(double length_m) {
  const double aside_m = std::max(20.0, 0.25 * length_m);
  return (length_m + 2 * aside_m) * 2 * aside_m;
}

// Counter of the seconds for a unit of `amount`, which an iteration does.
void count(benchmark::State& state, const char* name, double amount) {
  state.counters[name] =
      benchmark::Counter(amount * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// Times `what` on each leg.
template <class What>
void measure(benchmark::State& state, const std::string& rover, const std::string& terrain,
             std::size_t legs_count, const What& what) {
  const auto length_m = static_cast<int>(state.range(0));
  const std::vector<Leg>& legs = ::legs(rover, terrain, length_m, legs_count);
  for (auto _ : state) {
    for (const Leg& leg : legs) what(leg);
  }
  const double area_m2 = corridor_m2(length_m) * static_cast<double>(legs.size());
  const double spacing_m = lsos::map_spacing_m(legs.front().cost);
  count(state, "s_per_leg", static_cast<double>(legs.size()));
  count(state, "s_per_km2", area_m2 * 1e-6);
  count(state, "s_per_million_nodes", area_m2 * 1e-6 / (spacing_m * spacing_m));
}

void plan(benchmark::State& state, const std::string& rover, const std::string& terrain) {
  measure(state, rover, terrain, 8, [](const Leg& leg) {
    benchmark::DoNotOptimize(plan_leg(*leg.ground, leg.cost, leg.request));
  });
}

void plain_astar(benchmark::State& state, const std::string& rover, const std::string& terrain) {
  measure(state, rover, terrain, 2, [](const Leg& leg) {
    benchmark::DoNotOptimize(
        leg.cost.can_turn_on_spot
            ? lsos::test::grid_cost(*leg.ground, leg.cost, leg.request.goal_S_m, leg.request.aim)
            : lsos::test::pose_cost(*leg.ground, leg.cost, leg.request));
  });
}

const int registered = [] {
  for (const std::string rover : {"SEV", "LRV"}) {
    for (const std::string terrain : {"Craters", "LunarSouthPole"}) {
      const std::string legs = rover + "/" + terrain;
      benchmark::RegisterBenchmark(("plan/" + legs).c_str(), plan, rover, terrain)
          ->Arg(100)
          ->Arg(400)
          ->Arg(1000)
          ->Unit(benchmark::kMillisecond);
      // It uses a map of 25 m to either side, the planner's for this length.
      benchmark::RegisterBenchmark(("plain_astar/" + legs).c_str(), plain_astar, rover, terrain)
          ->Arg(100)
          ->Unit(benchmark::kMillisecond);
    }
  }
  return 0;
}();

}  // namespace
