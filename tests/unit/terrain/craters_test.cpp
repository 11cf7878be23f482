#include "terrain/craters.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "ground_fixture.h"

namespace lsos {
namespace {

TEST(CraterProfile, has_the_depth_and_rim_of_pike) {
  const double d = 100;
  // Rim crest to floor is depth_to_diameter; the rim stands 0.036/0.196 of that above the ground.
  EXPECT_NEAR(crater_height_m(50, d, 0.196) - crater_height_m(0, d, 0.196), 19.6, 1e-12);
  EXPECT_NEAR(crater_height_m(50, d, 0.196), 3.6, 1e-12);
  EXPECT_EQ(crater_height_m(150, d, 0.196), 0);
  EXPECT_EQ(crater_height_m(500, d, 0.196), 0);
}

TEST(CraterProfile, has_neither_steps_nor_kinks) {
  const double step = 1e-6;
  const auto slope = [&](double r) {
    return (crater_height_m(r + step, 20, 0.2) - crater_height_m(r, 20, 0.2)) / step;
  };
  for (double r = 0; r < 35; r += 0.001) {
    ASSERT_NEAR(crater_height_m(r, 20, 0.2), crater_height_m(r + step, 20, 0.2), 2 * step) << r;
    ASSERT_NEAR(slope(r), slope(r + 0.001), 1e-3) << r;
  }
  EXPECT_NEAR(slope(10 - step / 2), 0, 1e-5);  // the crest is level
}

TEST(CraterProfile, rises_to_the_rim_and_falls_beyond) {
  for (double r = 0; r < 29.9; r += 0.1) {
    const double rise = crater_height_m(r + 0.1, 20, 0.15) - crater_height_m(r, 20, 0.15);
    EXPECT_TRUE(r + 0.1 < 10.01 ? rise > 0 : rise < 0) << r;
  }
}

CraterSurface field() {
  CraterSurface surface;
  surface.density_pm2 = 2e-4;
  surface.diameter_min_m = 3;
  surface.diameter_max_m = 60;
  surface.exponent = 2;
  return surface;
}

TEST(CraterField, counts_follow_the_power_law) {
  const PlanePoint low{-2000, 1000};
  const PlanePoint high{2000, 5000};
  for (double exponent : {1.5, 2.0, 3.0}) {
    CraterSurface surface = field();
    surface.exponent = exponent;
    const std::vector<Crater> craters = craters_touching(surface, 42, low, high);
    const double area_m2 = 4000.0 * 4000.0;
    const auto larger = [&](double diameter_m) {
      return std::ranges::count_if(craters, [&](const Crater& c) {
        return c.diameter_m > diameter_m && c.centre.x_m >= low.x_m && c.centre.x_m < high.x_m &&
               c.centre.y_m >= low.y_m && c.centre.y_m < high.y_m;
      });
    };
    // None is larger than the largest, so its share is missing everywhere.
    const auto law = [&](double diameter_m) {
      return surface.density_pm2 * area_m2 *
             (std::pow(diameter_m / 3, -exponent) - std::pow(60.0 / 3, -exponent));
    };
    for (double diameter_m : {2.9999, 4.0, 6.0, 7.5, 12.0, 20.0, 40.0}) {
      const double expected = law(std::max(diameter_m, 3.0));
      EXPECT_NEAR(static_cast<double>(larger(diameter_m)), expected, 4 * std::sqrt(expected) + 1)
          << exponent << " " << diameter_m;
    }
    EXPECT_EQ(larger(60), 0);
  }
}

TEST(CraterField, positions_are_uniform) {
  const std::vector<Crater> craters = craters_touching(field(), 7, {0, 0}, {4000, 4000});
  // Sixteen squares of 1 km2 with 200 craters each but for the largest.
  std::array<int, 16> counts{};
  for (const Crater& c : craters) {
    const int column = static_cast<int>(std::floor(c.centre.x_m / 1000));
    const int row = static_cast<int>(std::floor(c.centre.y_m / 1000));
    if (column >= 0 && column < 4 && row >= 0 && row < 4) ++counts[row * 4 + column];
  }
  double chi2 = 0;
  for (int count : counts) chi2 += (count - 199.5) * (count - 199.5) / 199.5;
  EXPECT_LT(chi2, 39);  // 16 degrees of freedom: exceeded once in a thousand fields
  EXPECT_GT(chi2, 4);   // and a regular pattern would be no chance either
}

TEST(CraterField, a_look_at_a_part_finds_the_same_craters) {
  const std::vector<Crater> all = craters_touching(field(), 3, {-500, -500}, {500, 500});
  const PlanePoint low{20, -70};
  const PlanePoint high{36, -54};
  std::vector<double> expected;
  for (const Crater& c : all) {
    const double dx = c.centre.x_m - std::clamp(c.centre.x_m, low.x_m, high.x_m);
    const double dy = c.centre.y_m - std::clamp(c.centre.y_m, low.y_m, high.y_m);
    if (std::hypot(dx, dy) < 1.5 * c.diameter_m) expected.push_back(c.centre.x_m);
  }
  std::vector<double> found;
  for (const Crater& c : craters_touching(field(), 3, low, high)) found.push_back(c.centre.x_m);
  EXPECT_EQ(found, expected);
}

TerrainSpec crater_terrain() {
  TerrainSpec spec;
  CraterSurface surface = field();
  surface.base = {800, 0.05, 1};
  spec.surface = surface;
  return spec;
}

TEST(CraterGround, has_the_profile_of_its_craters) {
  const SiteFrame site = site_on("Moon", 0, 10, 800);
  const Ground ground(crater_terrain(), site, 11);
  const Ground plane(plane_terrain(800, 0.05, 1), site, 0);
  Ground::Probe probe(ground);
  Ground::Probe flat(plane);
  const std::vector<Crater> craters = craters_touching(field(), 11, {-300, -300}, {300, 300});
  double lowest_m = 0;
  for (double x = -200; x < 200; x += 13.7) {
    for (double y = -200; y < 200; y += 11.3) {
      // z such that the gnomonic coordinates are x, y: the tangent plane itself.
      double expected_m = 0;
      for (const Crater& c : craters) {
        expected_m +=
            crater_height_m(std::hypot(x - c.centre.x_m, y - c.centre.y_m), c.diameter_m, 0.15);
      }
      const double found_m =
          probe.sample({x, y, 0}).elevation_m - flat.sample({x, y, 0}).elevation_m;
      EXPECT_NEAR(found_m, expected_m, 0.01);
      lowest_m = std::min(lowest_m, found_m);
    }
  }
  EXPECT_LT(lowest_m, -0.2);
}

TEST(CraterGround, normals_are_gradients_of_the_gap) {
  const Ground ground(crater_terrain(), site_on("Moon", 0, 10, 800), 11);
  Ground::Probe probe(ground);
  for (double x = -150; x < 150; x += 17.3) {
    const Vec3 p = on_surface(ground, probe, {x, 0.6 * x + 3, 0});
    EXPECT_LT((probe.sample(p).normal_S - normal_by_differences(probe, p, 1e-4)).norm(), 1e-5);
  }
}

TEST(CraterGround, bits_depend_on_the_seed_alone) {
  const SiteFrame site = site_on("Moon", 0, 10, 800);
  const Ground one(crater_terrain(), site, 11);
  const Ground two(crater_terrain(), site, 11);
  const Ground other(crater_terrain(), site, 12);
  EXPECT_EQ(one.hash(), two.hash());
  EXPECT_NE(one.hash(), other.hash());
  std::vector<double> forward(2000), backward(2000);
  const auto point = [](int k) { return Vec3(0.05 * k, 0.03 * k - 20, 0); };
  std::thread thread([&] {
    Ground::Probe probe(two);
    for (int k = 1999; k >= 0; --k) backward[k] = probe.sample(point(k)).gap_m;
  });
  Ground::Probe probe(one);
  for (int k = 0; k < 2000; ++k) forward[k] = probe.sample(point(k)).gap_m;
  thread.join();
  EXPECT_EQ(forward, backward);
  Ground::Probe differs(other);
  int different = 0;
  for (int k = 0; k < 2000; ++k) different += differs.sample(point(k)).gap_m != forward[k];
  EXPECT_GT(different, 0);
}

}  // namespace
}  // namespace lsos
