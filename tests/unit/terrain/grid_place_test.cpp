// From grid coordinates back to places: the inverse of what every lookup does.
#include <cmath>

#include "ground_fixture.h"
#include "terrain/grid/height_grid.h"

namespace lsos {
namespace {

const std::vector<std::vector<double>> flat = rows_of(40, 30, [](int, int) { return 5.0; });

struct Grid {
  Grid(const std::string& crs, const std::string& geotransform, const SiteFrame& site)
      : plane(site) {
    const RasterSurface surface{TextRaster{crs, geotransform, "", flat}.write("r")};
    grid = make_raster_grid(surface, {"x.lua", 1}, plane);
  }
  SitePlane plane;
  std::unique_ptr<HeightGrid> grid;
};

// PROJ's own inverse is 2e-12 rad off beside a pole.
constexpr double tolerance_px = 2e-5;

void expect_round_trip(const HeightGrid& grid, const std::string& what) {
  const double period = grid.extent().period;
  for (const GridCoordinates at : {GridCoordinates{0, 0}, {39, 29}, {12.25, 17.5}, {-0.5, 29.5}}) {
    const auto place = grid.place(at);
    ASSERT_TRUE(place) << what;
    EXPECT_EQ(place->height_m, 0);
    EXPECT_LE(std::abs(place->lon_rad), M_PI) << what;
    const auto back = grid.coordinates(*place);
    ASSERT_TRUE(back) << what;
    const double off = back->u - at.u;
    EXPECT_NEAR(period > 0 ? std::remainder(off, period) : off, 0, tolerance_px) << what;
    EXPECT_NEAR(back->v, at.v, tolerance_px) << what;
  }
}

TEST(GridPlace, is_the_reverse_of_coordinates_on_every_crs) {
  struct Case {
    const char* crs;
    const char* geotransform;
    const char* body;
    double lon_deg, lat_deg;
  };
  for (const Case& c : {
           Case{"IAU_2015:30135", "-20, 1, 0, 15, 0, -1", "Moon", 0, -90},
           {"+proj=eqc +R=1737400 +lon_0=180", "-20, 1, 0, 15, 0, -1", "Moon", 180, 0},
           {"+proj=ortho +R=1737400 +lat_0=25 +lon_0=-46", "-20, 1, 0, 15, 0, -2", "Moon", -46, 25},
           {"+proj=laea +R=1738000 +lat_0=20 +lon_0=-30", "-15, 0, 1, -20, 1, 0", "Moon", -30, 20},
           {"IAU_2015:30100", "179.9, 0.01, 0, 20.1, 0, -0.01", "Moon", 180, 20},
           {"+proj=longlat +a=3396190 +rf=169.894447223612", "9.9, 0.01, 0, 45.1, 0, -0.01", "Mars",
            10, 45},
           {"IAU_2015:49911", "-1000, 100, 0, 150000, 0, -100", "Mars", 0, 2},
           {"EPSG:32610", "582678, 0.5, 0, 4141911, 0, -0.5", "Earth", -122.06, 37.42},
           {"EPSG:4326", "-80, 0.01, 0, 44, 0, -0.01", "Earth", -80, 44},
       }) {
    expect_round_trip(*Grid(c.crs, c.geotransform, site_on(c.body, c.lon_deg, c.lat_deg)).grid,
                      c.crs);
  }
}

TEST(GridPlace, is_where_closed_forms_say) {
  // South polar stereographic (Snyder 1987, 21-1): rho = 2 R tan(c/2), longitude from +y.
  const Grid polar("IAU_2015:30135", "0, 1000, 0, 0, 0, -1000", site_on("Moon", 0, -90));
  const auto place = polar.grid->place({29.5, 29.5});
  ASSERT_TRUE(place);
  EXPECT_NEAR(lon_deg(*place), 135, 1e-12);
  EXPECT_NEAR(place->lat_rad + M_PI / 2, 2 * std::atan(30000 * std::sqrt(2) / (2 * 1737400)),
              1e-12);
  // Planetographic rows of Mars, planetocentric results: tan(centric) = (1 - f)^2 tan(graphic).
  const Grid mars("+proj=longlat +a=3396190 +rf=169.894447223612", "9.9, 0.01, 0, 45.1, 0, -0.01",
                  site_on("Mars", 10, 45));
  const double polar_share = 1 - 1 / 169.894447223612;
  EXPECT_NEAR(mars.grid->place({9.5, 9.5})->lat_rad, std::atan(polar_share * polar_share), 1e-12);
}

TEST(GridPlace, ends_at_the_pole_and_where_the_projection_does) {
  // One degree per row from 10 degrees north of the pole's latitude downwards.
  const Grid geographic("IAU_2015:30100", "-180, 1, 0, 100, 0, -1", site_on("Moon", 0, 80));
  EXPECT_FALSE(geographic.grid->place({5, 9}));
  EXPECT_TRUE(geographic.grid->place({5, 10}));
  const Grid equirectangular("+proj=eqc +R=1737400", "0, 10000, 0, 2800000, 0, -10000",
                             site_on("Moon", 0, 80));
  EXPECT_FALSE(equirectangular.grid->place({5, 2}));
  EXPECT_TRUE(equirectangular.grid->place({5, 8}));
  const Grid disc("+proj=ortho +R=1737400", "0, 100000, 0, 100000, 0, -100000",
                  site_on("Moon", 0, 0));
  EXPECT_FALSE(disc.grid->place({30, 2}));
  EXPECT_TRUE(disc.grid->place({10, 2}));
}

TEST(GridPlace, of_generated_ground_lies_on_the_site_plane) {
  const SitePlane plane(site_on("Moon", 30, 60, 100));
  const auto grid = make_plane_grid(PlaneSurface{}, plane);
  const auto origin = grid->place({0, 0});
  ASSERT_TRUE(origin);
  EXPECT_NEAR(lon_deg(*origin), 30, 1e-12);
  EXPECT_NEAR(lat_deg(*origin), 60, 1e-12);
  EXPECT_EQ(origin->height_m, 0);
  const auto back = grid->coordinates(*grid->place({321.5, -77.25}));
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->u, 321.5, 1e-7);
  EXPECT_NEAR(back->v, -77.25, 1e-7);
}

}  // namespace
}  // namespace lsos
