#include "terrain/grid/patch.h"

#include <cmath>

#include "ground_fixture.h"
#include "terrain/grid/height_grid.h"

namespace lsos {
namespace {

TEST(Patch, holds_each_point_in_exactly_one_square_of_a_level) {
  const auto nowhere = ExactMap{[](const PlanePoint&) { return std::nullopt; }};
  const PatchKey key = Patch::key_of({-2048, 2047.999}, 0);
  EXPECT_EQ(key, (PatchKey{0, -1, 0}));
  const Patch patch(key, nowhere);
  EXPECT_TRUE(patch.holds({-2048, 0}));
  EXPECT_FALSE(patch.holds({0, 0}));
  EXPECT_FALSE(patch.holds({-2048, 2048}));
  EXPECT_EQ(Patch::key_of({-0.25, 0.5}, Patch::finest_level), (PatchKey{12, -1, 1}));
}

TEST(Patch, where_the_map_knows_no_place_it_is_not_good) {
  const auto nowhere = ExactMap{[](const PlanePoint&) { return std::nullopt; }};
  EXPECT_FALSE(Patch({0, 0, 0}, nowhere).is_good());
}

TEST(Patch, reproduces_cubics_with_their_derivatives) {
  const auto u = [](double x, double y) { return 1e5 + 0.5 * x - 1e-4 * x * y + 1e-7 * x * y * y; };
  const auto v = [](double x, double y) { return 7 - 0.25 * y + 1e-7 * x * x * x; };
  const ExactMap map{[&](const PlanePoint& at) {
    return std::optional(GridCoordinates{u(at.x_m, at.y_m), v(at.x_m, at.y_m)});
  }};
  const Patch patch({0, 1, -2}, map);
  ASSERT_TRUE(patch.is_good());
  const GridPoint found = patch.at({300, -400});
  EXPECT_NEAR(found.u, u(300, -400), 1e-9);
  EXPECT_NEAR(found.v, v(300, -400), 1e-9);
  EXPECT_NEAR(found.u_by_x, 0.5 + 1e-4 * 400 + 1e-7 * 400 * 400, 1e-11);
  EXPECT_NEAR(found.u_by_y, -1e-4 * 300 - 2e-7 * 300 * 400, 1e-11);
  EXPECT_NEAR(found.v_by_x, 3e-7 * 300 * 300, 1e-11);
  EXPECT_NEAR(found.v_by_y, -0.25, 1e-11);
}

TEST(Patch, joins_samples_on_both_sides_of_the_seam) {
  const ExactMap around{[](const PlanePoint& at) {
                          const double u = at.x_m - 128;
                          return std::optional(GridCoordinates{u < 0 ? u + 9000 : u, at.y_m});
                        },
                        9000};
  const Patch patch({0, 0, 0}, around);
  ASSERT_TRUE(patch.is_good());
  EXPECT_NEAR(std::remainder(patch.at({100, 0}).u - -28, 9000), 0, 1e-9);
  EXPECT_NEAR(patch.at({100, 0}).u_by_x, 1, 1e-9);
}

TEST(Patch, differences_of_the_exact_map_agree_with_a_fit) {
  const ExactMap map{[](const PlanePoint& at) {
    return std::optional(GridCoordinates{std::hypot(at.x_m, at.y_m), 2 * at.y_m});
  }};
  const auto exact = exact_grid_point(map, {300, 400});
  ASSERT_TRUE(exact);
  EXPECT_NEAR(exact->u, 500, 1e-12);
  EXPECT_NEAR(exact->u_by_x, 0.6, 1e-8);
  EXPECT_NEAR(exact->u_by_y, 0.8, 1e-8);
  EXPECT_NEAR(exact->v_by_y, 2, 1e-8);
}

struct Fitted {
  const char* file;
  const char* body;
  double lon_deg, lat_deg;
};

class RasterFits : public ::testing::TestWithParam<Fitted> {};

// The stated bound: 30 nanometres on rasters of a metre, which is rounding in PROJ's degrees.
TEST_P(RasterFits, meet_the_exact_projection) {
  const auto& [name, body, lon_deg, lat_deg] = GetParam();
  LSOS_NEEDS_REFERENCE(name);
  const std::string file = reference_file(name);
  const SitePlane plane(site_on(body, lon_deg, lat_deg));
  const auto grid = make_raster_grid({file, 1}, {}, plane);
  double largest_px = 0;
  for (int column = -20; column <= 20; column += 5) {
    for (int row = -20; row <= 20; row += 5) {
      const Patch patch = grid->patch({0, column, row});
      ASSERT_TRUE(patch.is_good()) << column << " " << row;
      largest_px = std::max(largest_px, patch.residual_px());
    }
  }
  RecordProperty("residual_px", std::to_string(largest_px * 1e9) + "e-9");
  EXPECT_LT(largest_px, 3e-8);
}

INSTANTIATE_TEST_SUITE_P(
    Patch, RasterFits,
    ::testing::Values(
        Fitted{"dem/moon/nobile_rim2_ldem_6_cut_1m.tif", "Moon", 59.1739, -83.8920},
        Fitted{"dem/moon/aristarchus_IMP_4p76m_height_slope_rock.tif", "Moon", -46.765, 25.048},
        Fitted{"dem/moon/LDEM_4.LBL", "Moon", 30, 40},
        Fitted{"dem/mars/gale_hirise_1m_missionDEM.tif", "Mars", 137.37, -4.6667},
        Fitted{"dem/earth/ames_roverscape_0p5m_UTM10.tif", "Earth", -122.0652, 37.4201}));

}  // namespace
}  // namespace lsos
