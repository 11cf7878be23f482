// Lines of sight by rendering, as in missions, and by marching, as for maps. The two methods share
// no code but the ground.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/random.h"
#include "mission/light/sight.h"
#include "mission/model/site.h"
#include "physics/drive.h"
#include "unit/terrain/ground_fixture.h"
#include "view/ground/sight_march.h"

namespace lsos::test {
namespace {

struct Agreement {
  int pairs = 0, equal = 0, seen = 0;
  double farthest_edge_m = 0;  // greatest clearance by marching where the methods differ
};

// Pairs of antennas at random places.
struct Pairs {
  int count;
  double around_m;  // range of the first end's x and y about the site's origin
  double shortest_m, longest_m;
  double highest_m;  // greatest antenna height; the least is an eighth of it
};

Agreement agreement(const Ground& ground, const Pairs& pairs) {
  Renderer renderer;
  Sight drawn(ground, renderer);
  SightMarch march(ground);
  Ground::Probe probe(ground);
  RandomStream random(7);
  const auto antenna = [&](double x_m, double y_m) -> Vec3 {
    const Vec3 on_plane(x_m, y_m, 0);
    const GroundSample sample = probe.sample(on_plane);
    return on_plane +
           (random.uniform(pairs.highest_m / 8, pairs.highest_m) - sample.gap_m) * sample.up_S;
  };
  Agreement found;
  for (; found.pairs < pairs.count; ++found.pairs) {
    const double x_m = random.uniform(-pairs.around_m, pairs.around_m);
    const double y_m = random.uniform(-pairs.around_m, pairs.around_m);
    const double azimuth_rad = random.uniform(0, 2 * std::numbers::pi);
    const double apart_m =
        pairs.shortest_m * std::pow(pairs.longest_m / pairs.shortest_m, random.uniform(0, 1));
    const Vec3 from_S_m = antenna(x_m, y_m);
    const Vec3 to_S_m =
        antenna(x_m + apart_m * std::sin(azimuth_rad), y_m + apart_m * std::cos(azimuth_rad));
    const bool is_drawn = drawn.line(from_S_m, to_S_m, {}).is_seen;
    const SightLine line = march.between(from_S_m, to_S_m);
    found.equal += is_drawn == line.is_free();
    found.seen += line.is_free();
    if (is_drawn != line.is_free()) {
      found.farthest_edge_m = std::max(found.farthest_edge_m, std::abs(line.clearance_m));
    }
  }
  std::printf(
      "of %d pairs %d are equal drawn and marched, %d see each other; where they differ "
      "the line passes at most %.2f m from an edge\n",
      found.pairs, found.equal, found.seen, found.farthest_edge_m);
  return found;
}

void expect_agreement(const Agreement& found) {
  EXPECT_GE(found.equal, 0.98 * found.pairs);
  EXPECT_GT(found.seen, 0.1 * found.pairs);
  EXPECT_LT(found.seen, 0.9 * found.pairs);
  EXPECT_LT(found.farthest_edge_m, 1);
}

TEST(SightMethods, agree_among_craters) {
  const Geodetic site = geodetic_from_degrees(31, 20);
  const auto ground = ground_at(shipped_terrain("Craters"), *find_body("Moon"), site, 3);
  expect_agreement(agreement(*ground, {1000, 500, 20, 1000, 0.8}));
}

// A raster on which detail as wide as the cells must leave their means unchanged.
TEST(SightMethods, agree_over_a_raster_of_large_cells) {
  const TextRaster raster{"+proj=stere +lat_0=-90 +R=1737400 +units=m", "100000,60,0,100000,0,-60",
                          "", rows_of(60, 60, [](int, int) { return 0.0; })};
  TerrainSpec spec = raster_terrain(raster.write("level"));
  spec.detail.emplace();
  spec.detail->craters.emplace();
  spec.detail->craters->age_gyr = 3.9;
  spec.detail->craters->diameter_min_m = 10;
  const double middle_m = 101800, south_m = 98200;
  const double colatitude_deg =
      2 * std::atan(std::hypot(middle_m, south_m) / (2 * 1737400)) * 180 / std::numbers::pi;
  const double lon_deg = std::atan2(middle_m, south_m) * 180 / std::numbers::pi;
  const Ground ground(spec, site_on("Moon", lon_deg, colatitude_deg - 90), 1);
  expect_agreement(agreement(ground, {300, 300, 1000, 2000, 2}));
}

TEST(SightMethods, agree_at_the_south_pole) {
  const Geodetic site = geodetic_from_degrees(129.78, -89.67);
  const auto ground = ground_at(shipped_terrain("LunarSouthPole"), *find_body("Moon"), site, 1);
  expect_agreement(agreement(*ground, {150, 8000, 20, 20e3, 8}));
}

}  // namespace
}  // namespace lsos::test
