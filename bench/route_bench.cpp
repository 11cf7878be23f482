// What planning a leg costs, by square kilometre of corridor and by million nodes of its map (a
// square kilometre at 1 m): the whole of it, on a map whose terrain tiles are warm, over craters
// and over a raster of rough ground, and the lattice search alone on a map that is sampled, for
// scale.
#include <benchmark/benchmark.h>

#include <cmath>

#include "lua/mission_files.h"
#include "mission/drive_table.h"
#include "mission/site.h"
#include "route/grid_search.h"
#include "route/route_planner.h"

namespace {

using lsos::Vec2;
using lsos::Vec3;

struct Scene {
  Scene(const std::string& rover, const std::string& terrain) {
    const auto catalog = lsos::read_catalog("");
    const lsos::Body& moon = *lsos::find_body("Moon");
    const lsos::Geodetic at = terrain == "LunarSouthPole" ? lsos::geodetic_from_degrees(30, -87.5)
                                                          : lsos::geodetic_from_degrees(10, 20);
    ground = lsos::ground_at(catalog->load_terrain(terrain), moon, at, 1);
    const lsos::RoverModel model = catalog->load_rover(rover);
    const double g_mps2 = lsos::gravity_mps2(moon, ground->site().origin());
    const lsos::VehicleConfig vehicle = lsos::make_vehicle(model.spec, "", g_mps2);
    cost =
        lsos::drive_cost(vehicle, ground->soils(), g_mps2, vehicle.cruise_speed_mps, model.limits);
    cost.load_w = lsos::load_w(model.power.loads, {});
  }
  std::unique_ptr<lsos::Ground> ground;
  lsos::DriveCost cost;
};

// As plan_leg's first corridor.
double corridor_km2(double length_m) {
  const double aside_m = std::max(20.0, 0.25 * length_m);
  return (length_m + 2 * aside_m) * 2 * aside_m * 1e-6;
}

// Seconds for one of what an iteration does `amount` of.
void count(benchmark::State& state, const char* name, double amount) {
  state.counters[name] =
      benchmark::Counter(amount * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void plan(benchmark::State& state, const std::string& rover, const std::string& terrain) {
  const Scene scene(rover, terrain);
  const auto length_m = static_cast<double>(state.range(0));
  lsos::LegRequest request;
  request.goal_S_m = {length_m, 0, 0};
  // Warms the tiles.
  if (lsos::plan_leg(*scene.ground, scene.cost, request).path_S_m.empty()) {
    state.SkipWithError("no way");
    return;
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(lsos::plan_leg(*scene.ground, scene.cost, request));
  }
  count(state, "s_per_km2", corridor_km2(length_m));
  const double spacing_m = lsos::map_spacing_m(scene.cost);
  count(state, "s_per_million_nodes", corridor_km2(length_m) / (spacing_m * spacing_m));
}

// At 1 m, whatever the rover's own spacing.
void search(benchmark::State& state, const std::string& rover) {
  const Scene scene(rover, "Craters");
  const auto length_m = static_cast<double>(state.range(0));
  const double aside_m = std::ceil(std::max(20.0, 0.25 * length_m));
  const lsos::StanceFinder finder(scene.cost);
  lsos::GroundMap map(*scene.ground, lsos::MapFrame(scene.ground->site(), Vec3::Zero()),
                      {-aside_m, -aside_m}, {length_m + aside_m, aside_m}, 1);
  lsos::LegCosts costs(map, finder, lsos::RouteAim::energy);
  std::size_t expanded = lsos::search_grid(costs, Vec2::Zero(), {length_m, 0}).expanded;
  for (auto _ : state) {
    expanded = lsos::search_grid(costs, Vec2::Zero(), {length_m, 0}).expanded;
  }
  state.counters["expanded"] = static_cast<double>(expanded);
  count(state, "s_per_km2", corridor_km2(length_m));
}

const int registered = [] {
  for (const std::string rover : {"SEV", "LRV"}) {
    for (const std::string terrain : {"Craters", "LunarSouthPole"}) {
      const std::string name = "plan/" + rover + "/" + terrain;
      benchmark::RegisterBenchmark(name.c_str(), plan, rover, terrain)
          ->Arg(100)
          ->Arg(400)
          ->Arg(1000)
          ->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::RegisterBenchmark("search_at_1_m/SEV", search, "SEV")
      ->Arg(100)
      ->Arg(400)
      ->Arg(1000)
      ->Unit(benchmark::kMillisecond);
  return 0;
}();

}  // namespace
