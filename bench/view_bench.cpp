// Time of an exposure to the Sun: a panel in one direction, the whole disc, and the ground between,
// on a terrain of 1 km2 and of 10,000 km2. Also of a line of sight, and of a camera picture.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "mission/light/sight.h"
#include "view/exposure/panel_view.h"
#include "view/exposure/sun_column.h"
#include "view/exposure/sun_disc.h"
#include "view/picture/ground_view.h"
#include "view/picture/scene_picture.h"

namespace {

using lsos::Vec3;

constexpr double deg = std::numbers::pi / 180;
const Vec3 sun(std::cos(1.5 * deg), 0, std::sin(1.5 * deg));
constexpr double disc_rad = 0.2666 * deg;

// A mesh with about as many triangles as a rover.
lsos::Mesh rover() {
  lsos::Mesh mesh;
  for (int k = 0; k < 12; ++k) {
    append(mesh, lsos::cylinder_mesh(0.4, 0.3, 40), lsos::Mat3::Identity(),
           {0.9 * (k % 6) - 2.2, k < 6 ? -1.0 : 1.0, -1.5});
  }
  append(mesh, lsos::box_mesh({4, 2, 2}), lsos::Mat3::Identity(), {0, 0, -1.2});
  append(mesh, lsos::cylinder_mesh(0.05, 2), lsos::Mat3::Identity(), {2, 0, 0});
  return mesh;
}

const lsos::PanelFace panel{Vec3::Zero(), 0.7 * Vec3::UnitY(), 0.5 * Vec3::UnitZ()};

void look(benchmark::State& state, int directions) {
  const lsos::Gpu gpu;
  lsos::PanelView view(gpu);
  const lsos::Mesh mesh = rover();
  std::vector<Vec3> towards;
  for (const auto& s : lsos::disc_samples(sun, disc_rad, directions))
    towards.push_back(s.direction);
  for (auto _ : state) benchmark::DoNotOptimize(view.visible_shares(panel, mesh, towards));
  state.SetLabel(gpu.name());
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

lsos::TerrainSpec cratered(double reach_m) {
  lsos::TerrainSpec spec;
  lsos::ReliefSurface relief;
  // Hills cover the terrain as far as it reaches.
  for (int k = 1; k < 6; ++k) {
    const double lon_rad = reach_m * k / 6 / 1737400;
    relief.landforms.push_back({"hill", lon_rad, 0, reach_m / 6, 0, reach_m / 200});
  }
  spec.layers = {relief};
  spec.detail.emplace();
  spec.detail->craters.emplace();
  spec.detail->craters->age_gyr = 3.5;
  spec.detail->craters->diameter_min_m = 1;
  spec.detail->craters->diameter_max_m = 500;
  return spec;
}

// `is_new`: each time from another place, like a rover that moves; tiles are made on the run.
void ground(benchmark::State& state, double reach_m, bool is_new) {
  const lsos::SiteFrame site(*lsos::find_body("Moon"), {0, 0, 0});
  const lsos::Ground terrain(cratered(reach_m), site, 1);
  double y_m = 0;
  std::size_t triangles = 0;
  lsos::Ground::Probe probe(terrain);
  for (auto _ : state) {
    const double gap_m = probe.sample({0, y_m, 0}).gap_m;
    const lsos::Mesh mesh =
        ground_mesh(terrain, lsos::sun_column({0, y_m, 2 - gap_m}, 1.2, sun, disc_rad));
    benchmark::DoNotOptimize(mesh.vertices.data());
    triangles = mesh.triangles.size();
    if (is_new) y_m += 4;
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

// Both together, with the ground already made.
void whole(benchmark::State& state, double reach_m) {
  const lsos::Gpu gpu;
  lsos::PanelView view(gpu);
  const lsos::SiteFrame site(*lsos::find_body("Moon"), {0, 0, 0});
  const lsos::Ground terrain(cratered(reach_m), site, 1);
  lsos::Ground::Probe probe(terrain);
  const double gap_m = probe.sample({0, 0, 0}).gap_m;
  lsos::Mesh mesh = ground_mesh(terrain, lsos::sun_column({0, 0, 2 - gap_m}, 1.2, sun, disc_rad));
  append(mesh, rover(), lsos::Mat3::Identity(), Vec3::Zero());
  std::vector<Vec3> towards;
  for (const auto& s : lsos::disc_samples(sun, disc_rad, 16)) towards.push_back(s.direction);
  for (auto _ : state) benchmark::DoNotOptimize(view.visible_shares(panel, mesh, towards));
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

// Line of sight from one antenna to another over hills and craters, as a rover that drives needs
// it: each time from another place (every 4 m) or from the same.
void sight(benchmark::State& state, double distance_m, bool is_new) {
  lsos::Renderer renderer;
  const lsos::SiteFrame site(*lsos::find_body("Moon"), {0, 0, 0});
  const lsos::Ground terrain(cratered(1e4), site, 1);
  lsos::Sight between(terrain, renderer);
  lsos::Ground::Probe probe(terrain);
  const auto antenna = [&](double x_m, double y_m, double height_m) {
    return Vec3(x_m, y_m, height_m - probe.sample({x_m, y_m, 0}).gap_m);
  };
  double y_m = 0, seen = 0;
  for (auto _ : state) {
    seen += between.line(antenna(0, y_m, 4), antenna(distance_m, 0, 10), {}).share;
    if (is_new) y_m += 4;
  }
  state.counters["seen"] = benchmark::Counter(seen, benchmark::Counter::kAvgIterations);
}

// A picture of 1280 x 720 of ground whose tiles are not made yet.
void picture(benchmark::State& state) {
  const lsos::Gpu gpu;
  const lsos::SiteFrame site(*lsos::find_body("Moon"), {0, 0, 0});
  for (auto _ : state) {
    const lsos::Ground terrain(cratered(1e4), site, 1);
    const Vec3 under_m(0, 0, -lsos::Ground::Probe(terrain).sample(Vec3::Zero()).gap_m);
    const lsos::Camera camera =
        lsos::camera_towards(under_m + Vec3(-9, -4, 4), under_m + Vec3::UnitZ(), Vec3::UnitZ());
    const lsos::TerrainShadow shadow(terrain, camera.eye_S_m, sun, disc_rad,
                                     sector_of(site, camera));
    lsos::Scene scene;
    scene.sun_S = sun;
    scene.disc_rad = disc_rad;
    scene.air = lsos::air_of("Moon", 1.5 * deg);
    scene.ground = ground_view(terrain, camera, shadow, scene.air.ground);
    scene.bodies.push_back({{}, under_m - camera.eye_S_m, 5});
    lsos::Mesh solids;
    append(solids, rover(), lsos::Mat3::Identity(), under_m + Vec3(0, 0, 2.2) - camera.eye_S_m);
    append(scene.bodies.back().mesh, solids, Vec3(0.7, 0.7, 0.7), &shadow);
    benchmark::DoNotOptimize(draw(gpu, scene, camera).rgb.data());
  }
}

const auto registered = [] {
  using benchmark::RegisterBenchmark;
  RegisterBenchmark("panel/one_direction", [](auto& s) { look(s, 1); });
  RegisterBenchmark("panel/disc_of_16", [](auto& s) { look(s, 16); });
  RegisterBenchmark("panel/disc_of_64", [](auto& s) { look(s, 64); });
  for (const auto& [name, reach_m] : {std::pair{"1_km2", 1e3}, std::pair{"10000_km2", 1e5}}) {
    const double reach = reach_m;
    RegisterBenchmark((std::string("ground/parked/") + name).c_str(),
                      [reach](auto& s) { ground(s, reach, false); });
    RegisterBenchmark((std::string("ground/moving/") + name).c_str(),
                      [reach](auto& s) { ground(s, reach, true); });
    RegisterBenchmark((std::string("disc_with_ground/") + name).c_str(),
                      [reach](auto& s) { whole(s, reach); });
  }
  for (const auto& [name, distance_m] : {std::pair{"100_m", 100.}, {"1_km", 1e3}, {"10_km", 1e4}}) {
    const double distance = distance_m;
    RegisterBenchmark((std::string("sight/parked/") + name).c_str(),
                      [distance](auto& s) { sight(s, distance, false); });
    RegisterBenchmark((std::string("sight/moving/") + name).c_str(),
                      [distance](auto& s) { sight(s, distance, true); });
  }
  RegisterBenchmark("picture", picture)->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
