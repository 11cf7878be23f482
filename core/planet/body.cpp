#include "planet/body.h"

#include <erfa.h>

#include <array>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/sim_time.h"
#include "base/units.h"

namespace lsos {

namespace {

constexpr double pi = std::numbers::pi;
// Radii: IAU 2015 (Archinal et al. 2018) for the Moon and for the sphere that Mars maps in
// IAU_2015:49900 use; WGS84 for Earth. GM: DE440 (Park et al. 2021) for the Moon, Konopliv et al.
// 2016 for Mars without its moons, WGS84 for Earth.
// Rotation: Archinal et al. 2018, WGS84 for Earth. Ground: LOLA, MOLA, Challenger Deep and Mount
// Everest. Mars is flattened but its reference surface is not: the northern plains, 5 km below the
// areoid, lie up to 24.3 km below that sphere. Albedo: Mars as a whole (recalled), and the usual
// value for Earth of models of solar energy (Bird and Hulstrom 1981).
constexpr std::array<Body, 3> bodies{{
    {.id = BodyId::moon,
     .name = "Moon",
     .equatorial_radius_m = 1'737'400.0,
     .flattening = 0.0,
     .gm_m3ps2 = 4.902800118e12,
     .crs = "IAU_2015:30100",
     .north_polar_crs = "IAU_2015:30130",
     .south_polar_crs = "IAU_2015:30135",
     .rotation_radps = radians(13.17635815) / day_length_s,
     .solar_day_s = 29.530589 * day_length_s,
     .sun_step_deg = 0.05,
     .earth_interval_s = 2400,
     .lowest_ground_m = -9.2e3,
     .highest_ground_m = 10.8e3,
     .air = Air::none,
     .assumed_soil = "ApolloNominal"},
    {.id = BodyId::mars,
     .name = "Mars",
     .equatorial_radius_m = 3'396'190.0,
     .flattening = 0.0,
     .gm_m3ps2 = 4.282837362e13,
     .crs = "IAU_2015:49900",
     .north_polar_crs = "IAU_2015:49930",
     .south_polar_crs = "IAU_2015:49935",
     .rotation_radps = radians(350.891982443297) / day_length_s,
     .solar_day_s = 88775.244,
     .sun_step_deg = 0.25,
     .earth_interval_s = 123.3,
     .lowest_ground_m = -25e3,
     .highest_ground_m = 21.3e3,
     .air = Air::dusty,
     .assumed_optical_depth = 0.5,
     .assumed_albedo = 0.25,
     .assumed_soil = "Ding2011_planetary_simulant"},
    {.id = BodyId::earth,
     .name = "Earth",
     .equatorial_radius_m = 6'378'137.0,
     .flattening = 1.0 / 298.257223563,
     .gm_m3ps2 = 3.986004418e14,
     .crs = "EPSG:4326",
     .north_polar_crs = "EPSG:3995",
     .south_polar_crs = "EPSG:3031",
     .rotation_radps = 7.2921150e-5,
     .solar_day_s = day_length_s,
     .sun_step_deg = 0.25,
     .earth_interval_s = 123.3,
     .lowest_ground_m = -11.1e3,
     .highest_ground_m = 8.9e3,
     .air = Air::clear,
     .assumed_albedo = 0.2,
     .assumed_soil = "DrySand"},
}};

Vec3 direction(double lon_rad, double lat_rad) {
  const double cos_lat = std::cos(lat_rad);
  return {cos_lat * std::cos(lon_rad), cos_lat * std::sin(lon_rad), std::sin(lat_rad)};
}

// Length of the geodesic by Lambert's formula (Lambert 1942): a great circle between the reduced
// latitudes, corrected to first order in the flattening.
double geodesic_m(const Body& body, const Geodetic& a, const Geodetic& b) {
  const double f = body.flattening;
  const auto reduced = [f](double lat_rad) {
    return std::atan2((1 - f) * std::sin(lat_rad), std::cos(lat_rad));
  };
  const double beta_a = reduced(a.lat_rad);
  const double beta_b = reduced(b.lat_rad);
  const Vec3 to_a = direction(a.lon_rad, beta_a);
  const Vec3 to_b = direction(b.lon_rad, beta_b);
  const double sigma = std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b));

  const auto square = [](double value) { return value * value; };
  const double sin2_p = square(std::sin((beta_a + beta_b) / 2));
  const double sin2_q = square(std::sin((beta_b - beta_a) / 2));
  const double sin2_half = square(std::sin(sigma / 2));
  const double cos2_half = square(std::cos(sigma / 2));
  // Both ratios stay within 0..1; at a coincident or antipodal pair they are 0/0 and multiply 0.
  const double x =
      cos2_half > 0 ? (sigma - std::sin(sigma)) * sin2_p * (1 - sin2_q) / cos2_half : 0;
  const double y =
      sin2_half > 0 ? (sigma + std::sin(sigma)) * (1 - sin2_p) * sin2_q / sin2_half : 0;
  return body.equatorial_radius_m * (sigma - f / 2 * (x + y));
}

}  // namespace

std::span<const Body> all_bodies() { return bodies; }

const Body* find_body(std::string_view name) {
  for (const Body& body : bodies) {
    if (body.name == name) return &body;
  }
  return nullptr;
}

double lon_deg(const Geodetic& place) { return place.lon_rad * (180 / pi); }
double lat_deg(const Geodetic& place) { return place.lat_rad * (180 / pi); }

Geodetic geodetic_from_degrees(double lon_deg, double lat_deg, double height_m) {
  return {std::remainder(lon_deg, 360.0) * (pi / 180), lat_deg * (pi / 180), height_m};
}

Vec3 p_F_m(const Body& body, const Geodetic& place) {
  if (body.flattening == 0) {
    return (body.equatorial_radius_m + place.height_m) * direction(place.lon_rad, place.lat_rad);
  }
  Vec3 p;
  const int status = eraGd2gce(body.equatorial_radius_m, body.flattening, place.lon_rad,
                               place.lat_rad, place.height_m, p.data());
  LSOS_ASSERT(status == 0);
  return p;
}

Geodetic geodetic(const Body& body, const Vec3& p) {
  Geodetic place;
  if (body.flattening == 0) {
    place.lon_rad = std::atan2(p.y(), p.x());
    place.lat_rad = std::atan2(p.z(), std::hypot(p.x(), p.y()));
    place.height_m = p.norm() - body.equatorial_radius_m;
    return place;
  }
  Vec3 copy = p;  // ERFA takes non-const arrays that it does not write
  const int status = eraGc2gde(body.equatorial_radius_m, body.flattening, copy.data(),
                               &place.lon_rad, &place.lat_rad, &place.height_m);
  LSOS_ASSERT(status == 0);
  return place;
}

double surface_distance_m(const Body& body, const Geodetic& a, const Geodetic& b) {
  if (body.flattening != 0) return geodesic_m(body, a, b);
  const Vec3 to_a = direction(a.lon_rad, a.lat_rad);
  const Vec3 to_b = direction(b.lon_rad, b.lat_rad);
  // The arctangent keeps centimetres at small and at antipodal angles.
  return body.equatorial_radius_m * std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b));
}

}  // namespace lsos
