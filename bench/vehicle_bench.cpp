// Time of a physics step of a rover (control, wheels on a 1 m raster, dynamics, bookkeeping)
// against a bare step of the same tree: Bullet's articulated-body algorithm, positions and forward
// kinematics, with a constant force per wheel. Run both in one run and divide.
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "lua/host/mission_reader.h"
#include "mission/model/site.h"
#include "planet/ellipsoid.h"
#include "vehicle/path_follower.h"
#include "vehicle/vehicle.h"

namespace {

namespace fs = std::filesystem;
using lsos::Vec3;

struct Case {
  const char* rover;
  const char* planet;
  double radius_m;  // radius of the raster's sphere
};
constexpr Case cases[] = {{"SEV", "Moon", 1737400},
                          {"LRV", "Moon", 1737400},
                          {"MER", "Mars", 3396190},
                          {"ATHLETE", "Moon", 1737400},
                          {"Husky", "Earth", 6378137}};

// Gentle hills at 1 m on the body's equator, as raw samples that GDAL reads through a VRT.
class HillRaster {
 public:
  explicit HillRaster(double radius_m)
      : folder_(fs::temp_directory_path() / fmt::format("lsos-vehicle-bench-{}", ::getpid())) {
    fs::create_directories(folder_);
    constexpr int size = 1024;
    std::ofstream samples(folder_ / "hills.raw", std::ios::binary);
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const float height_m = static_cast<float>(std::sin(row * 0.13) + std::cos(column * 0.11));
        samples.write(reinterpret_cast<const char*>(&height_m), sizeof height_m);
      }
    }
    std::ofstream(file()) << fmt::format(
        R"(<VRTDataset rasterXSize="{0}" rasterYSize="{0}">
<SRS>+proj=eqc +R={1} +units=m +no_defs</SRS>
<GeoTransform>-512, 1, 0, 512, 0, -1</GeoTransform>
<VRTRasterBand dataType="Float32" band="1" subClass="VRTRawRasterBand">
<SourceFilename relativetoVRT="1">hills.raw</SourceFilename>
<ImageOffset>0</ImageOffset><PixelOffset>4</PixelOffset><LineOffset>{2}</LineOffset>
</VRTRasterBand></VRTDataset>
)",
        size, radius_m, 4 * size);
  }
  ~HillRaster() { fs::remove_all(folder_); }
  std::string file() const { return folder_ / "hills.vrt"; }

 private:
  fs::path folder_;
};

struct Scene {
  explicit Scene(const Case& of) : raster(of.radius_m) {
    const auto catalog = lsos::read_catalog("");
    const lsos::Body& body = *lsos::find_body(of.planet);
    lsos::TerrainSpec spec;
    spec.name = "Hills";
    spec.layers = {lsos::RasterSurface{raster.file(), 1}};
    spec.soil = catalog->load_soil("ApolloNominal");
    ground = lsos::ground_at(spec, body, {}, 0);
    config = lsos::make_vehicle(catalog->load_rover(of.rover).spec, "",
                                lsos::gravity_mps2(body, ground->site().origin()));
  }
  HillRaster raster;
  std::unique_ptr<lsos::Ground> ground;
  lsos::VehicleConfig config;
};

void drive(benchmark::State& state, const Case& of) {
  const Scene scene(of);
  lsos::Vehicle vehicle(scene.config, *scene.ground);
  if (!vehicle.place({}, 0.3).empty()) return state.SkipWithError("it does not stand");
  double heading = 1;
  const auto steps = lsos::exchange_period / scene.config.step;
  for (auto _ : state) {
    // The rover drives a slalom, so that steering works too; each iteration is an exchange period
    // with its control and report.
    const lsos::VehicleReport report = vehicle.report();
    if (std::fmod(vehicle.distance_m(), 20) < 10) heading = -heading;
    vehicle.command({scene.config.cruise_speed_mps, heading * 0.02 * report.speed_mps, false});
    vehicle.advance(lsos::exchange_period);
  }
  const double step_count = static_cast<double>(state.iterations()) * static_cast<double>(steps);
  state.counters["us_a_step"] = benchmark::Counter(
      step_count * 1e-6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["x_real_time"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * lsos::seconds(lsos::exchange_period),
      benchmark::Counter::kIsRate);
}

btVector3 bt(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

void bare(benchmark::State& state, const Case& of) {
  const Scene scene(of);
  const lsos::VehicleConfig& config = scene.config;
  btMultiBody body(static_cast<int>(config.links.size()), config.chassis.mass_kg,
                   bt(config.chassis.moments_kgm2), false, false);
  for (std::size_t i = 0; i < config.links.size(); ++i) {
    const lsos::LinkConfig& link = config.links[i];
    const Vec3 from_m =
        link.p_PJ_m - (link.parent < 0
                           ? config.p_BC_m
                           : config.links[static_cast<std::size_t>(link.parent)].p_JC_m);
    const auto set_up = [&](auto setup) {
      (body.*setup)(static_cast<int>(i), link.inertia.mass_kg, bt(link.inertia.moments_kgm2),
                    link.parent, btQuaternion(0, 0, 0, 1), bt(link.axis), bt(from_m),
                    bt(link.p_JC_m), true);
    };
    if (link.joint == lsos::JointType::revolute) {
      set_up(&btMultiBody::setupRevolute);
    } else {
      set_up(&btMultiBody::setupPrismatic);
    }
  }
  body.finalizeMultiDof();
  btAlignedObjectArray<btScalar> r;
  btAlignedObjectArray<btVector3> v;
  btAlignedObjectArray<btMatrix3x3> m;
  btAlignedObjectArray<btQuaternion> rotations;
  btAlignedObjectArray<btVector3> origins;
  const double step_s = lsos::seconds(config.step);
  for (auto _ : state) {
    for (std::size_t i = 0; i < config.links.size(); ++i) {
      if (config.links[i].wheel) body.addLinkForce(static_cast<int>(i), btVector3(0, 0, 1e-3));
    }
    body.computeAccelerationsArticulatedBodyAlgorithmMultiDof(step_s, r, v, m, false, false, false);
    body.stepPositionsMultiDof(step_s);
    body.forwardKinematics(rotations, origins);
    body.clearForcesAndTorques();
  }
  state.counters["us_a_step"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * 1e-6,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

const int registered = [] {
  for (const Case& of : cases) {
    benchmark::RegisterBenchmark(fmt::format("{}/whole", of.rover).c_str(), drive, of);
    benchmark::RegisterBenchmark(fmt::format("{}/bare", of.rover).c_str(), bare, of);
  }
  return 0;
}();

}  // namespace
