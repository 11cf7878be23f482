#include "planet/sunlight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lsos {

namespace {

constexpr double solar_constant_wpm2 = 1361;
constexpr double au_m = 149597870700;  // IAU 2012, resolution B2
constexpr double air_scale_m = 8434;   // RT/g at 288 K

// No place sees a Sun this far below its horizon; eclipses are not computed there.
constexpr double night_rad = 0.2;

// Light that air adds to the direct light; `outside_wpm2` is what falls across it without air.
void add_scattered(Sunlight& light, const Body& on, double outside_wpm2, double optical_depth,
                   double ground_albedo) {
  const double sine = std::sin(light.seen.elevation_rad);
  if (sine <= 0) return;
  if (on.air == Air::clear) {
    const double direct_share = outside_wpm2 > 0 ? light.irradiance_wpm2 / outside_wpm2 : 0;
    light.sky_wpm2 = outside_wpm2 * sine * clear_sky_diffuse_share(direct_share);
  } else {
    const LayerLight layer = dusty_light(mars_dust, optical_depth, sine, ground_albedo);
    light.aureole_wpm2 = outside_wpm2 * layer.aureole;
    light.sky_wpm2 = outside_wpm2 * sine * layer.sky;
  }
  light.ground_wpm2 = ground_albedo * level_wpm2(light);
}

}  // namespace

double irradiance_wpm2(double sun_distance_m) {
  const double au = sun_distance_m / au_m;
  return solar_constant_wpm2 / (au * au);
}

double air_mass(double elevation_rad, double height_m) {
  const double elevation_deg = std::max(0.0, elevation_rad * 180 / std::numbers::pi);
  const double at_sea_level = 1 / (std::sin(elevation_deg * std::numbers::pi / 180) +
                                   0.50572 * std::pow(elevation_deg + 6.07995, -1.6364));
  return at_sea_level * std::exp(-height_m / air_scale_m);
}

double clear_sky_share(double elevation_rad, double height_m) {
  if (elevation_rad < 0) return 0;
  return std::pow(0.7, std::pow(air_mass(elevation_rad, height_m), 0.678));
}

double dusty_sky_share(double elevation_rad, double optical_depth) {
  if (optical_depth <= 0) return 1;
  if (elevation_rad <= 0) return 0;
  return std::exp(-optical_depth / std::sin(elevation_rad));
}

double level_wpm2(const Sunlight& light) {
  const double direct_wpm2 = light.irradiance_wpm2 * (1 - light.eclipsed) + light.aureole_wpm2;
  return std::max(0.0, std::sin(light.seen.elevation_rad)) * direct_wpm2 + light.sky_wpm2;
}

Sunlight sunlight(const Body& on, const Geodetic& place, Instant at, double optical_depth,
                  double ground_albedo) {
  const Vec3 point_F_m = p_F_m(on, place);
  const Sighting sun = sighting(on, point_F_m, CelestialBody::sun, at);
  Sunlight light{sky_position(on, place, sun.direction_F), sun.disc_rad,
                 irradiance_wpm2(sun.distance_m), 0};
  const double outside_wpm2 = light.irradiance_wpm2;
  const bool is_up = light.seen.elevation_rad > -night_rad;
  if (on.id == BodyId::moon && is_up) light.eclipsed = eclipsed_share(on, point_F_m, sun, at);
  if (on.air == Air::clear) {
    light.seen.elevation_rad += refraction_rad(light.seen.elevation_rad, place.height_m);
    light.irradiance_wpm2 *= clear_sky_share(light.seen.elevation_rad, place.height_m);
  } else {
    light.irradiance_wpm2 *= dusty_sky_share(light.seen.elevation_rad, optical_depth);
  }
  add_scattered(light, on, outside_wpm2, optical_depth, ground_albedo);
  return light;
}

SimTime sun_interval(const Body& body) {
  const SimTime exact = from_seconds(body.solar_day_s * body.sun_step_deg / 360);
  return exact - exact % exchange_period;
}

Vec3 direction_S(const SiteFrame& site, const Vec3& p_S_m, const SkyPosition& seen) {
  const Vec3 level = std::sin(seen.azimuth_rad) * site.east_S(p_S_m) +
                     std::cos(seen.azimuth_rad) * site.north_S(p_S_m);
  return std::cos(seen.elevation_rad) * level + std::sin(seen.elevation_rad) * site.up_S(p_S_m);
}

}  // namespace lsos
