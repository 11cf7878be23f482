#include "planet/sky.h"

#include <erfa.h>
#include <erfam.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planet/rotation.h"

namespace lsos {

namespace {

CelestialBody celestial(const Body& body) {
  switch (body.id) {
    case BodyId::moon:
      return CelestialBody::moon;
    case BodyId::mars:
      return CelestialBody::mars;
    case BodyId::earth:
    case BodyId::other:
      break;
  }
  return CelestialBody::earth;
}

Instant before(Instant at, double time_s) { return {at.tai_us - std::llround(time_s * 1e6)}; }

}  // namespace

Sighting sighting(const Body& on, const Vec3& p_F_m, CelestialBody target, Instant at) {
  const BarycentricState centre = barycentric_state(celestial(on), at);
  const Mat3 R = R_FI(on, at);
  const Vec3 p_I_m = centre.p_I_m + R.transpose() * p_F_m;
  const Vec3 spin_F_mps = on.rotation_radps * Vec3::UnitZ().cross(p_F_m);
  const Vec3 v_I_mps = centre.v_I_mps + R.transpose() * spin_F_mps;

  // Position of the target when its light left; two iterations leave an error of less than a metre.
  Vec3 to_I_m = barycentric_state(target, at).p_I_m - p_I_m;
  for (int round = 0; round < 2; ++round) {
    to_I_m = barycentric_state(target, before(at, to_I_m.norm() / ERFA_CMPS)).p_I_m - p_I_m;
  }
  const double sun_m = (barycentric_state(CelestialBody::sun, at).p_I_m - p_I_m).norm();

  Sighting seen;
  const bool is_about_earth = on.id == BodyId::moon && target == CelestialBody::earth;
  const Vec3 frame_I_mps = is_about_earth ? barycentric_state(target, at).v_I_mps : Vec3::Zero();
  seen.distance_m = (to_I_m + to_I_m.norm() / ERFA_CMPS * frame_I_mps).norm();
  seen.disc_rad = std::asin(std::min(1.0, disc_radius_m(target) / seen.distance_m));
  double natural[3], velocity[3], proper[3];
  for (int i = 0; i < 3; ++i) {
    natural[i] = to_I_m[i] / to_I_m.norm();
    velocity[i] = v_I_mps[i] / ERFA_CMPS;
  }
  const double per_lorentz = std::sqrt(1 - v_I_mps.squaredNorm() / (ERFA_CMPS * ERFA_CMPS));
  eraAb(natural, velocity, sun_m / ERFA_DAU, per_lorentz, proper);
  seen.direction_F = (R * Vec3(proper[0], proper[1], proper[2])).normalized();
  return seen;
}

double covered_share(double disc_rad, double cover_rad, double separation_rad) {
  if (separation_rad >= disc_rad + cover_rad) return 0;
  if (separation_rad <= cover_rad - disc_rad) return 1;
  if (separation_rad <= disc_rad - cover_rad) {
    return cover_rad * cover_rad / (disc_rad * disc_rad);
  }
  // The overlap is two circular segments, on a flat sky.
  const double r = disc_rad, c = cover_rad, d = separation_rad;
  const double at_disc = std::acos(std::clamp((d * d + r * r - c * c) / (2 * d * r), -1.0, 1.0));
  const double at_cover = std::acos(std::clamp((d * d + c * c - r * r) / (2 * d * c), -1.0, 1.0));
  const double area = r * r * (at_disc - std::sin(2 * at_disc) / 2) +
                      c * c * (at_cover - std::sin(2 * at_cover) / 2);
  return area / (std::numbers::pi * r * r);
}

namespace {

double share_covered_by(const Sighting& cover, const Sighting& disc) {
  const double separation_rad = std::atan2(disc.direction_F.cross(cover.direction_F).norm(),
                                           disc.direction_F.dot(cover.direction_F));
  return covered_share(disc.disc_rad, cover.disc_rad, separation_rad);
}

}  // namespace

SkyPosition sky_position(const Body& on, const Geodetic& place, const Vec3& direction_F) {
  const SiteFrame site(on, place);
  const Vec3 direction_S = site.R_FS().transpose() * direction_F;
  double azimuth_rad = std::atan2(direction_S.x(), direction_S.y());
  if (azimuth_rad < 0) azimuth_rad += 2 * std::numbers::pi;
  return {azimuth_rad, std::atan2(direction_S.z(), std::hypot(direction_S.x(), direction_S.y()))};
}

double refraction_rad(double elevation_rad, double height_m) {
  constexpr double lowest_deg = -1;
  const double elevation_deg = elevation_rad * 180 / std::numbers::pi;
  const double at_deg = std::max(elevation_deg, lowest_deg);
  const double standard_arcmin =
      1.02 / std::tan((at_deg + 10.3 / (at_deg + 5.11)) * std::numbers::pi / 180);
  // The formula is for 1010 hPa and 10 deg C. U.S. Standard Atmosphere 1976, troposphere.
  const double temperature_k = 288.15 - 0.0065 * std::min(height_m, 11000.0);
  const double pressure_hpa = 1013.25 * std::pow(temperature_k / 288.15, 5.25588);
  const double bent_deg = standard_arcmin / 60 * (pressure_hpa / 1010) * (283.15 / temperature_k);
  const double left = std::clamp((elevation_deg + 90) / (lowest_deg + 90), 0.0, 1.0);
  return bent_deg * left * std::numbers::pi / 180;
}

double eclipsed_share(const Body& moon, const Vec3& p_F_m, const Sighting& sun, Instant at) {
  return share_covered_by(sighting(moon, p_F_m, CelestialBody::earth, at), sun);
}

Sky sky(const Body& on, const Geodetic& place, Instant at) {
  const Vec3 point_F_m = p_F_m(on, place);
  const Sighting sun = sighting(on, point_F_m, CelestialBody::sun, at);
  Sky result;
  result.sun = sky_position(on, place, sun.direction_F);
  result.sun_distance_m = sun.distance_m;
  result.sun_disc_rad = sun.disc_rad;
  // Seen from the centre, the Sun's direction is the zenith of the sub-solar place. On an ellipsoid
  // that zenith belongs to the latitude of the direction.
  const Vec3 from_centre_F = sighting(on, Vec3::Zero(), CelestialBody::sun, at).direction_F;
  result.sub_solar = {std::atan2(from_centre_F.y(), from_centre_F.x()),
                      std::asin(std::clamp(from_centre_F.z(), -1.0, 1.0)), 0};
  if (celestial(on) == CelestialBody::earth) {
    result.sun_refracted_rad =
        result.sun.elevation_rad + refraction_rad(result.sun.elevation_rad, place.height_m);
    return result;
  }
  const Sighting earth = sighting(on, point_F_m, CelestialBody::earth, at);
  result.earth = sky_position(on, place, earth.direction_F);
  result.earth_distance_m = earth.distance_m;
  if (celestial(on) == CelestialBody::moon) result.eclipsed = share_covered_by(earth, sun);
  return result;
}

}  // namespace lsos
