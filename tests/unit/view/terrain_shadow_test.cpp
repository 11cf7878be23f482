// Terrain's shadow in pictures, against the Sun's disc marched over the same ground.
#include "view/ground/terrain_shadow.h"

#include <gmock/gmock.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "unit/view/view_fixture.h"
#include "view/exposure/ground_light.h"

namespace lsos {
namespace {

using test::deg;
using test::direction;

constexpr double disc_rad = 0.27 * deg;

struct Relief {
  SiteFrame site{*find_body("Moon"), geodetic_from_degrees(0, -85)};
  Ground ground{test::bowl_and_hill(), site, 1};
};

double mean_difference(Relief& relief, double azimuth_rad, const GroundSector& sector) {
  const Vec3 eye_S_m(0, 0, 20), sun_S = direction(azimuth_rad, 4 * deg);
  const TerrainShadow shadow(relief.ground, eye_S_m, sun_S, disc_rad, sector);
  GroundLightProbe march(relief.ground, 0.5);
  Ground::Probe probe(relief.ground);
  double sum = 0;
  int dark = 0, count = 0;
  for (double r_m = 20; r_m < 2500; r_m *= 1.1) {
    for (const double aside : {-0.3, -0.1, 0.1, 0.3}) {
      const Vec3 over_m = r_m * (sector.ahead_S + aside * Vec3::UnitZ().cross(sector.ahead_S));
      const GroundSample sample = probe.sample(eye_S_m + over_m);
      const Vec3 p_m = over_m - sample.gap_m * sample.up_S;
      const auto light = march.at(relief.site.geodetic(eye_S_m + p_m), sun_S, disc_rad);
      sum += std::abs(shadow.on_ground(p_m) - light->sun_fraction);
      dark += light->sun_fraction < 0.5;
      ++count;
    }
  }
  EXPECT_GT(dark, 5);
  return sum / count;
}

TEST(TerrainShadow, is_where_marching_has_it) {
  Relief relief;
  for (const double azimuth_deg : {0.0, 20.0, 180.0, 200.0}) {
    EXPECT_LT(mean_difference(relief, azimuth_deg * deg, {Vec3::UnitY(), 4}), 0.07) << azimuth_deg;
  }
}

// A mountain range on the horizon hides the disc's lower part, over rough ground near by.
TEST(TerrainShadow, of_a_range_far_away_hides_a_part_of_the_disc) {
  TerrainSpec spec = test::bowl_and_hill();
  std::get<ReliefSurface>(spec.layers[0])
      .landforms.push_back({"range", 0, -84.2 * deg, 20e3, 0, 1800});
  spec.detail = Detail{};
  spec.detail->roughness = Roughness{};
  const SiteFrame site(*find_body("Moon"), geodetic_from_degrees(0, -85));
  const Ground ground(spec, site, 1);
  const Vec3 eye_S_m(-300, -300, 20);
  GroundLightProbe march(ground, 0.5);
  Ground::Probe probe(ground);
  int partly = 0;
  for (const double elevation_deg : {3.8, 3.95, 4.1, 4.25}) {
    const Vec3 sun_S = direction(0, elevation_deg * deg);
    const TerrainShadow shadow(ground, eye_S_m, sun_S, disc_rad);
    double drawn = 0, marched = 0, apart = 0;
    int count = 0;
    for (double x_m = -40; x_m <= 40; x_m += 7) {
      for (double y_m = -40; y_m <= 40; y_m += 7, ++count) {
        const Vec3 over_m(x_m, y_m, 0);
        const GroundSample sample = probe.sample(eye_S_m + over_m);
        const Vec3 p_m = over_m - sample.gap_m * sample.up_S;
        const double here = shadow.on_ground(p_m);
        const double true_here =
            march.at(site.geodetic(eye_S_m + p_m), sun_S, disc_rad)->sun_fraction;
        drawn += here;
        marched += true_here;
        apart += std::abs(here - true_here);
      }
    }
    std::printf("%.2f deg: %.3f, marched %.3f; apart by %.3f\n", elevation_deg, drawn / count,
                marched / count, apart / count);
    partly += marched / count > 0.2 && marched / count < 0.8;
    EXPECT_NEAR(drawn / count, marched / count, 0.055) << elevation_deg;
    EXPECT_LT(apart / count, 0.07) << elevation_deg;
  }
  EXPECT_GE(partly, 2);
}

TEST(TerrainShadow, is_the_same_in_a_sector_alone) {
  Relief relief;
  for (const double azimuth_deg : {20.0, 200.0}) {
    const double all = mean_difference(relief, azimuth_deg * deg, {Vec3::UnitY(), 4});
    EXPECT_DOUBLE_EQ(mean_difference(relief, azimuth_deg * deg, {Vec3::UnitY(), 0.4}), all);
  }
}

TEST(TerrainShadow, darkens_what_stands_low_in_it_and_not_what_rises_above_it) {
  Relief relief;
  const TerrainShadow shadow(relief.ground, {0, 0, 20}, direction(0, 2 * deg), disc_rad);
  EXPECT_EQ(shadow.at({0, 600, -60}), 0);
  EXPECT_EQ(shadow.at({0, 600, 300}), 1);
}

// A level raster, 400 m to a side.
class SmallRaster {
 public:
  SmallRaster() {
    std::filesystem::create_directories(folder_);
    constexpr int size = 40;
    std::ofstream samples(folder_ / "level.raw", std::ios::binary);
    for (int k = 0; k < size * size; ++k) samples.write("\0\0\0\0", 4);
    std::ofstream(file()) << R"(<VRTDataset rasterXSize="40" rasterYSize="40">
<SRS>+proj=eqc +R=1737400 +units=m +no_defs</SRS>
<GeoTransform>-200, 10, 0, 200, 0, -10</GeoTransform>
<VRTRasterBand dataType="Float32" band="1" subClass="VRTRawRasterBand">
<SourceFilename relativetoVRT="1">level.raw</SourceFilename>
<ImageOffset>0</ImageOffset><PixelOffset>4</PixelOffset><LineOffset>160</LineOffset>
</VRTRasterBand></VRTDataset>
)";
  }
  ~SmallRaster() { std::filesystem::remove_all(folder_); }
  std::string file() const { return folder_ / "level.vrt"; }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("lsos-shadow-" + std::to_string(::getpid()));
};

// The end of a raster is no cliff: where no ground is known the Sun shines on what is drawn there.
TEST(TerrainShadow, leaves_light_where_no_ground_is_known) {
  const SmallRaster raster;
  TerrainSpec spec;
  spec.layers = {RasterSurface{raster.file(), 1}};
  const SiteFrame site(*find_body("Moon"), geodetic_from_degrees(0, 0));
  const Ground ground(spec, site, 1);
  EXPECT_TRUE(Ground::Probe(ground).sample({0, 150, 0}).is_ground());
  EXPECT_FALSE(Ground::Probe(ground).sample({0, 250, 0}).is_ground());
  const TerrainShadow shadow(ground, {0, 0, 10}, direction(0.3, 30 * deg), disc_rad, {});
  for (const double north_m : {-3000.0, -195.0, 0.0, 195.0, 300.0, 3000.0}) {
    EXPECT_NEAR(shadow.on_ground({0, north_m, -10}), 1, 1e-6) << north_m;
  }
}

}  // namespace
}  // namespace lsos
