// Viewsheds against the horizon of a sphere, and against lines marched one by one.
#include "view/ground/viewshed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "support/reference_data.h"
#include "terrain/raster/raster.h"
#include "unit/view/view_fixture.h"
#include "view/ground/sight_march.h"

namespace lsos {
namespace {

using test::deg;

Viewshed marched(const Ground& ground, const MapHeights* heights, const Observer& observer,
                 const ViewSector& sector) {
  Viewshed view(ground, heights, observer, sector);
  GroundProbes probes = view.probes();
  for (std::size_t ray = 0; ray < view.ray_count(); ++ray) view.march(ray, probes);
  return view;
}

TEST(Viewshed, ends_at_the_horizon_of_a_sphere_and_is_endless_when_flat) {
  TerrainSpec spec;
  spec.layers = {PlaneSurface{}};
  const Ground ground(spec, SiteFrame(*find_body("Moon"), {0, 0, 0}), 0);
  const double diameter_m = 2 * 1737400;
  const Geodetic eye{0, 0, 50};
  const ViewSector sector{0, 2 * std::numbers::pi, 0, 40e3};
  const Viewshed round = marched(ground, nullptr, {eye, 200, false}, sector);
  const Viewshed flat = marched(ground, nullptr, {eye, 200, true}, sector);
  const double horizon_m = std::sqrt(diameter_m * 50) + std::sqrt(diameter_m * 10);
  for (double azimuth = 0; azimuth < 2 * std::numbers::pi; azimuth += 0.37) {
    for (const double share : {0.001, 0.5, 0.98, 1.02, 1.5}) {
      const double away_rad = share * horizon_m / 1737400;
      const Geodetic place{away_rad * std::sin(azimuth), away_rad * std::cos(azimuth), 10};
      EXPECT_EQ(round.sees(ground.site().p_S_m(place)), share < 1) << azimuth << " " << share;
      EXPECT_TRUE(flat.sees(ground.site().p_S_m(place))) << azimuth << " " << share;
    }
  }
}

// A map that lies entirely to one side of the observer, and a place within it.
TEST(Viewshed, looks_only_where_the_map_lies) {
  const Body& moon = *find_body("Moon");
  const MapGrid grid = grid_of_window(moon, {10, 20, 11, 21}, 500);
  const SiteFrame site(moon, {9 * deg, 20.5 * deg, 0});
  const ViewSector aside = sector_of(grid, site, {9 * deg, 20.5 * deg, 2});
  EXPECT_LT(aside.width_rad, 60 * deg);
  EXPECT_NEAR(aside.azimuth_low_rad + aside.width_rad / 2, 90 * deg, 3 * deg);
  const double degree_m = 1737400 * deg;
  EXPECT_NEAR(aside.nearest_m, degree_m * std::cos(20.5 * deg), 1000);
  EXPECT_NEAR(aside.farthest_m, degree_m * std::hypot(0.5, 2 * std::cos(20.3 * deg)), 1500);
  const ViewSector within = sector_of(grid, site, {10.1 * deg, 20.1 * deg, 2});
  EXPECT_EQ(within.width_rad, 2 * std::numbers::pi);
  EXPECT_EQ(within.nearest_m, 0);
}

// Sets the heights of a map's cells to those of the ground.
void find_heights(const Ground& ground, MapHeights& heights) {
  for (int row = 0; row < heights.rows(); ++row) {
    std::span<float> heights_m = heights.row(row);
    for (std::size_t column = 0; column < heights_m.size(); ++column) {
      const auto place = heights.map().place({static_cast<double>(column), 1.0 * row});
      const auto height_m = place ? ground.elevation_m(*place) : std::nullopt;
      if (height_m) heights_m[column] = static_cast<float>(*height_m);
    }
  }
}

struct GlobalCase {
  double lon_deg, lat_deg;
  MapWindow window;
};

// A global raster in degrees: inside it, across its seam, around a pole. At least 99.5 % of 400
// cells of each map agreed; within 8 degrees of the observer 98.0 %. All differences are at edges:
// the marched lines use the smooth ground, whose crests are higher than those of the map, which is
// linear between cells.
TEST(Viewshed, of_a_global_raster_is_what_lines_one_by_one_say) {
  LSOS_NEEDS_REFERENCE("dem/moon/LDEM_4.LBL");
  TerrainSpec spec;
  RasterSurface surface;
  surface.file = reference_file("dem/moon/LDEM_4.LBL");
  spec.layers = {surface};
  const Body& moon = *find_body("Moon");
  const Raster raster(surface, {}, &moon);
  constexpr double cell_m = 7580;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const auto& [lon_deg, lat_deg, window] :
       {GlobalCase{40, -3, {30, -13, 50, 7}}, GlobalCase{-150, 30, {-162, 21, -138, 39}},
        GlobalCase{179.9, -60, {155, -70, -155, -50}}, GlobalCase{10, 85, {-180, 60, 180, 90}}}) {
    const Geodetic place = geodetic_from_degrees(lon_deg, lat_deg);
    const Ground ground(spec, SiteFrame(moon, place), 0);
    const MapGrid grid = grid_of_raster(raster, window, {{}, surface.file});
    MapHeights heights(grid, moon);
    find_heights(ground, heights);
    const double eye_m = ground.elevation_m(place).value() + 3000;
    const Geodetic eye{place.lon_rad, place.lat_rad, eye_m};
    const Viewshed view =
        marched(ground, &heights, {eye, cell_m, false}, sector_of(grid, ground.site(), eye));
    SightMarch march(ground);
    int alike = 0, seen = 0;
    constexpr int count = 400;
    for (int k = 0; k < count; ++k) {
      const double column = std::floor(unit(random) * grid.columns);
      const double row = std::floor(unit(random) * grid.rows);
      Geodetic target = heights.map().place({column, row}).value();
      target.height_m = ground.elevation_m(target).value() + 1000;
      const Vec3 target_S_m = ground.site().p_S_m(target);
      const bool is_seen = march.sees(ground.site().p_S_m(eye), target_S_m);
      seen += is_seen ? 1 : 0;
      alike += view.sees(target_S_m) == is_seen ? 1 : 0;
    }
    std::printf("%g,%g: %.2f %% alike, %.1f %% seen\n", lon_deg, lat_deg, 100.0 * alike / count,
                100.0 * seen / count);
    EXPECT_GE(alike, 0.98 * count);
    EXPECT_GT(seen, 0.01 * count);
    EXPECT_LT(seen, 0.9 * count);
  }
}

}  // namespace
}  // namespace lsos
