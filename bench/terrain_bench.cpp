// Time of a ground sample: height and normal of the raster alone, with detail upon it, and over a
// coarser layer; and time of making detail.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "terrain/detail/detail.h"
#include "terrain/grid/height_grid.h"
#include "terrain/ground.h"

namespace {

namespace fs = std::filesystem;
using namespace lsos;

// Hills at 2 m on the Moon's equator, as raw samples that GDAL reads through a VRT.
std::string hill_raster() {
  static const std::string file = [] {
    const fs::path folder =
        fs::temp_directory_path() / fmt::format("lsos-terrain-bench-{}", ::getpid());
    fs::create_directories(folder);
    constexpr int size = 1024;
    std::ofstream samples(folder / "hills.raw", std::ios::binary);
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const auto height_m = static_cast<float>(std::sin(row * 0.13) + std::cos(column * 0.11));
        samples.write(reinterpret_cast<const char*>(&height_m), sizeof height_m);
      }
    }
    std::ofstream(folder / "hills.vrt") << fmt::format(
        R"(<VRTDataset rasterXSize="{0}" rasterYSize="{0}">
<SRS>+proj=eqc +R=1737400 +units=m +no_defs</SRS>
<GeoTransform>-1024, 2, 0, 1024, 0, -2</GeoTransform>
<VRTRasterBand dataType="Float32" band="1" subClass="VRTRawRasterBand">
<SourceFilename relativetoVRT="1">hills.raw</SourceFilename>
<ImageOffset>0</ImageOffset><PixelOffset>4</PixelOffset><LineOffset>{1}</LineOffset>
</VRTRasterBand></VRTDataset>
)",
        size, 4 * size);
    return (folder / "hills.vrt").string();
  }();
  return file;
}

Detail detail(bool has_rocks) {
  Detail detail;
  detail.craters.emplace();
  detail.craters->age_gyr = 3.9;
  detail.craters->diameter_min_m = 1;
  detail.craters->diameter_max_m = 200;
  detail.roughness = Roughness{0.02, 0.7, 16};
  if (has_rocks) detail.rocks = RockPopulation{0.02, 0.2, 4, 0.5};
  return detail;
}

TerrainSpec terrain(bool is_enhanced) {
  TerrainSpec spec;
  spec.layers = {RasterSurface{hill_raster()}};
  if (is_enhanced) spec.detail = detail(true);
  return spec;
}

// Random points of a square whose tiles are cached.
void look(benchmark::State& state, const TerrainSpec& spec) {
  const SiteFrame site(*find_body("Moon"), {0, 0, 0});
  const Ground ground(spec, site, 1);
  Ground::Probe probe(ground);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-60, 60);
  std::vector<Vec3> points(4096);
  for (Vec3& p : points) p = {uniform(random), uniform(random), 3};
  for (const Vec3& p : points) probe.sample(p);
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(probe.sample(points[k++ & 4095]));
}

// Heights at 0.25 m, tile after tile; the rate is in km2 per second.
void make(benchmark::State& state, bool is_over_raster) {
  const SiteFrame site(*find_body("Moon"), {0, 0, 0});
  const SitePlane plane(site);
  const auto grid =
      is_over_raster ? make_raster_grid({hill_raster()}, {}, plane) : make_plane_grid({}, plane);
  const DetailSetting setting{is_over_raster ? 2.0 : 16.0, 1, is_over_raster, 1e9};
  const DetailField field(detail(false), *grid, Stereographic(site.body(), 0, 0), setting, 1);
  std::int64_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(field.tile({60 + k % 16, 60 + k / 16 % 16}));
    ++k;
  }
  const double side_km = 64 * field.spacing_m() / 1000;
  state.counters["s_a_km2"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * side_km * side_km,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

const auto registered = [] {
  benchmark::RegisterBenchmark("look/raster", [](auto& s) { look(s, terrain(false)); });
  benchmark::RegisterBenchmark("look/enhanced", [](auto& s) { look(s, terrain(true)); });
  benchmark::RegisterBenchmark("make/plain", [](auto& s) { make(s, false); });
  benchmark::RegisterBenchmark("make/over_raster", [](auto& s) { make(s, true); });
  return true;
}();

}  // namespace
