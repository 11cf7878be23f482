#include "terrain/detail/rocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lsos {
namespace {

// Values of the formula, and the rocks drawn against it. No measured field of rocks is available.
TEST(Rocks, cover_as_much_as_published) {
  RockPopulation p;
  p.cover = 0.1;
  EXPECT_NEAR(rock_cover(p, 0.3), 0.037, 0.003);
  EXPECT_NEAR(rock_cover(p, 1), 0.0037, 0.0005);
  const PlaneRectangle area{{0, 0}, {200, 200}};
  p.diameter_min_m = 0.2;
  const auto rocks = rocks_touching(p, 3, area);
  for (const double larger_m : {0.2, 0.4, 0.8}) {
    double covered_m2 = 0, count = 0;
    for (const Rock& r : rocks) {
      if (r.diameter_m <= larger_m) continue;
      covered_m2 += std::numbers::pi / 4 * r.diameter_m * r.diameter_m;
      ++count;
    }
    EXPECT_NEAR(covered_m2 / 4e4 / rock_cover(p, larger_m), 1, 0.03 + 4 / std::sqrt(count));
    EXPECT_NEAR(count / 4e4, rocks_pm2(p, larger_m), 4 * std::sqrt(count) / 4e4);
  }
}

TEST(Rocks, have_the_volume_of_their_shapes) {
  const Rock rock{{}, 2, 1};
  double sum_m3 = 0;
  for (double r = 0.0005; r < 1; r += 0.001) {
    sum_m3 += 2 * std::numbers::pi * r * 0.001 * rock.height_m * rock_shape(r * r).height;
  }
  EXPECT_NEAR(rock_volume_m3(rock), sum_m3, 1e-5);
  const RockPopulation p{0.1, 0.2, 3, 0.5};
  double drawn_m3 = 0;
  for (const Rock& drawn : rocks_touching(p, 3, {{0, 0}, {300, 300}}, 0.3, 0.7)) {
    drawn_m3 += rock_volume_m3(drawn);
  }
  EXPECT_NEAR(drawn_m3 / 9e4 / rock_volume_pm2(p, 0.3, 0.7), 1, 0.02);
}

}  // namespace
}  // namespace lsos
