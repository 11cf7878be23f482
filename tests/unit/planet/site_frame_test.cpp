#include "planet/site_frame.h"
#include "planet/ellipsoid.h"
#include "planet/vertical_cells.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace lsos {
namespace {

using std::numbers::pi;

SiteFrame frame(std::string_view body, double lon_deg, double lat_deg, double height_m = 0) {
  return {*find_body(body), geodetic_from_degrees(lon_deg, lat_deg, height_m)};
}

TEST(SiteFrame, has_its_origin_at_the_place_and_points_east_north_up) {
  for (const Body& body : all_bodies()) {
    const SiteFrame site = frame(body.name, 59.17, -83.9, 1025);
    EXPECT_LT(site.p_S_m(site.origin()).norm(), 1e-8);
    EXPECT_LT((site.east_S(Vec3::Zero()) - Vec3::UnitX()).norm(), 1e-12);
    EXPECT_LT((site.north_S(Vec3::Zero()) - Vec3::UnitY()).norm(), 1e-12);
    EXPECT_LT((site.up_S(Vec3::Zero()) - Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_NEAR(site.height_m({0, 0, 7}), 1032, 1e-8);
    EXPECT_NEAR(site.R_FS().determinant(), 1, 1e-12);
  }
}

TEST(SiteFrame, the_moon_falls_29_m_below_the_tangent_plane_at_10_km) {
  const SiteFrame site = frame("Moon", 10, 20);
  const double angle = 10000.0 / 1737400.0;
  const Geodetic there{site.origin().lon_rad, site.origin().lat_rad + angle, 0};
  const Vec3 p = site.p_S_m(there);
  EXPECT_NEAR(p.z(), 1737400 * (std::cos(angle) - 1), 1e-6);
  EXPECT_NEAR(p.z(), -28.8, 0.05);
  const Vec3 up = site.up_S(p);
  EXPECT_NEAR(std::acos(up.z()), angle, 1e-9);
  EXPECT_NEAR(std::acos(up.z()) * 180 / pi, 0.33, 0.005);
  EXPECT_NEAR(site.height_m(p), 0, 1e-8);
  // Gravity tilts with the vertical and points down.
  const Vec3 g = site.gravity_S_mps2(p);
  EXPECT_LT((g.normalized() + up).norm(), 1e-12);
  EXPECT_NEAR(g.norm(), gravity_mps2(site.body(), there), 1e-12);
}

TEST(SiteFrame, goes_to_geodetic_coordinates_and_back) {
  for (const Body& body : all_bodies()) {
    const SiteFrame site = frame(body.name, 137.37, -4.67, -4460);
    const Vec3 p(3210, -7450, 42);
    EXPECT_LT((site.p_S_m(site.geodetic(p)) - p).norm(), 1e-7);
    EXPECT_LT((site.p_S_m_from_fixed(site.p_F_m(p)) - p).norm(), 1e-8);
    EXPECT_NEAR(site.geodetic(p).height_m, site.height_m(p), 1e-8);
  }
}

TEST(SiteFrame, its_vertical_agrees_with_geodetic_coordinates) {
  for (const Body& body : all_bodies()) {
    const SiteFrame site = frame(body.name, -122.06, 37.4, 800);
    for (double lat = -90; lat <= 90; lat += 7.5) {
      for (const double height_m : {-10000.0, 0.0, 3000.0, 10000.0, 100000.0}) {
        const Geodetic place = geodetic_from_degrees(-60, lat, height_m);
        const Vec3 p = site.p_S_m(place);
        const Vec3 up =
            (site.p_S_m({place.lon_rad, place.lat_rad, height_m + 1e6}) - p).normalized();
        const Vertical found = site.vertical(p);
        const bool is_far = height_m > 10000;
        EXPECT_NEAR(found.height_m, height_m, is_far ? 1e-7 : 1e-8) << body.name << lat;
        EXPECT_LT((found.up_S - up).norm(), is_far ? 1e-7 : 1e-9) << body.name << lat;
        EXPECT_NEAR(site.sin_latitude(found.up_S), std::sin(place.lat_rad), is_far ? 1e-7 : 1e-9);
      }
    }
  }
}

TEST(SiteFrame, up_is_the_gradient_of_height) {
  for (const Body& body : all_bodies()) {
    const SiteFrame site = frame(body.name, -122.06, 37.4);
    const Vec3 p(12000, -30000, 500);
    const double step_m = 10;
    Vec3 gradient;
    for (int i = 0; i < 3; ++i) {
      const Vec3 step = step_m * Vec3::Unit(i);
      gradient[i] = (site.height_m(p + step) - site.height_m(p - step)) / (2 * step_m);
    }
    EXPECT_LT((gradient - site.up_S(p)).norm(), 1e-8) << body.name;
    EXPECT_NEAR(site.up_S(p).dot(site.north_S(p)), 0, 1e-12);
    EXPECT_NEAR(site.up_S(p).dot(site.east_S(p)), 0, 1e-12);
  }
}

TEST(SiteFrame, north_points_at_the_pole) {
  const SiteFrame site = frame("Moon", 0, -89.9);
  const Vec3 p(800, 300, 0);
  const Geodetic here = site.geodetic(p);
  const Geodetic north{here.lon_rad, here.lat_rad + 1e-6, here.height_m};
  EXPECT_LT(((site.p_S_m(north) - p).normalized() - site.north_S(p)).norm(), 1e-5);
}

TEST(SiteFrame, stands_at_a_pole) {
  const SiteFrame site = frame("Moon", 0, -90);
  EXPECT_TRUE(site.north_S(Vec3::Zero()).allFinite());
  EXPECT_NEAR(site.north_S(Vec3::Zero()).norm(), 1, 1e-12);
  // The tiny remainder of cos(90 degrees) decides on a meridian; it is that of longitude 0.
  EXPECT_LT((site.north_S(Vec3::Zero()) - Vec3::UnitY()).norm(), 1e-9);
}

TEST(SiteFrame, gravity_on_earth_is_along_the_ellipsoid_normal) {
  const SiteFrame site = frame("Earth", 15, 45);
  const Vec3 p(0, 20000, 100);
  EXPECT_LT((site.gravity_S_mps2(p).normalized() + site.up_S(p)).norm(), 1e-12);
  EXPECT_NEAR(site.gravity_S_mps2(p).norm(), gravity_mps2(site.body(), site.geodetic(p)), 1e-9);
}

TEST(VerticalCells, are_the_vertical_to_a_nanometre) {
  for (const char* name : {"Moon", "Mars", "Earth"}) {
    const SiteFrame site(*find_body(name), geodetic_from_degrees(20, 47, 300));
    VerticalCells cells(site);
    double worst_m = 0, worst_rad = 0;
    for (int k = 0; k < 20000; ++k) {
      // The points lie all over 40 km, and return to cells used before.
      const double x = 20e3 * std::sin(0.7 * k), y = 20e3 * std::cos(1.3 * k);
      const Vec3 p(x, y, -(x * x + y * y) / 4e6 + 50 * std::sin(0.1 * k));
      const Vertical here = cells.at(p), exact = site.vertical(p);
      worst_m = std::max(worst_m, std::abs(here.height_m - exact.height_m));
      worst_rad = std::max(worst_rad, (here.up_S - exact.up_S).norm());
    }
    // No cell has a number here.
    const Vec3 away = Vec3(-1e300, 3, 4);
    EXPECT_EQ(std::isnan(cells.at(away).height_m), std::isnan(site.vertical(away).height_m));
    EXPECT_TRUE(std::isnan(cells.at(Vec3::Constant(NAN)).height_m));
    EXPECT_LT(worst_m, 2e-10) << name;
    EXPECT_LT(worst_rad, 5e-15) << name;
  }
}

}  // namespace
}  // namespace lsos
