#include "route/search/corridor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "test_rover.h"

namespace lsos::test {
namespace {

double off_m(const Vec2& at_m, const Line2& line) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec2 way_m = line[k + 1] - line[k];
    const double share = std::clamp((at_m - line[k]).dot(way_m) / way_m.squaredNorm(), 0.0, 1.0);
    least_m = std::min(least_m, (at_m - line[k] - share * way_m).norm());
  }
  return least_m;
}

TEST(Corridor, holds_what_is_near_a_line_and_nothing_far_from_it) {
  const Site site({});
  const GroundMap map(site.ground(), MapFrame(site.ground().site(), {0, 0, 0}), {-50, -40},
                      {70, 60}, 0.7);
  const Line2 line{{0, 0}, {30, 7}, {30, 50}, {68, 58}};
  constexpr double near_m = 9;
  const Corridor corridor(map, line, near_m);
  int near = 0, far = 0;
  for (double x_m = -50; x_m <= 70; x_m += 0.5) {
    for (double y_m = -40; y_m <= 60; y_m += 0.5) {
      const Vec2 at_m(x_m, y_m);
      const double aside_m = off_m(at_m, line);
      if (aside_m < near_m) {
        ++near;
        EXPECT_TRUE(corridor.holds(at_m)) << at_m.transpose();
      } else if (aside_m > 1.5 * near_m) {
        ++far;
        EXPECT_FALSE(corridor.holds(at_m)) << at_m.transpose();
      }
    }
  }
  EXPECT_GT(near, 5000);
  EXPECT_GT(far, 20'000);
}

TEST(Corridor, is_beyond_the_edges_of_the_map_as_at_them) {
  const Site site({});
  const GroundMap map(site.ground(), MapFrame(site.ground().site(), {0, 0, 0}), {-50, -40},
                      {50, 40}, 0.7);
  const Corridor corridor(map, {{-48, -38}, {-48, 38}}, 9);
  EXPECT_TRUE(corridor.holds({-51, -38}));
  EXPECT_TRUE(corridor.holds({-48, -41}));
  EXPECT_TRUE(corridor.holds({-500, 0}));
  EXPECT_FALSE(corridor.holds({51, 0}));
}

}  // namespace
}  // namespace lsos::test
