#include "planet/ellipsoid.h"

#include <cmath>

#include "base/error.h"

namespace lsos {

namespace {

double length(double a, double b) { return std::sqrt(a * a + b * b); }

// Latitude from the reduced latitude (Bowring 1976), and that from a first guess which is right at
// all heights to second order in the flattening (Bowring 1985).
Vertical vertical_on_ellipsoid(const Body& body, const Vec3& p) {
  const double a = body.equatorial_radius_m;
  const double f = body.flattening;
  const double b = a * (1 - f);
  const double e2 = f * (2 - f);
  const double second_e2 = e2 / ((1 - f) * (1 - f));

  const double rho = length(p.x(), p.y());
  const double r = length(rho, p.z());
  const double along = b * p.z() * (1 + second_e2 * b / r);
  const double across = a * rho;
  const double per_size = 1 / length(along, across);
  const double sin_beta = along * per_size;
  const double cos_beta = across * per_size;
  const double up = p.z() + second_e2 * b * sin_beta * sin_beta * sin_beta;
  const double out = rho - e2 * a * cos_beta * cos_beta * cos_beta;
  const double per_normal = 1 / length(up, out);
  const double sin_lat = up * per_normal;
  const double cos_lat = out * per_normal;
  Vertical vertical;
  // On the axis every meridian is right; the one of longitude 0 is taken.
  const double cos_lon = rho > 0 ? p.x() / rho : 1;
  const double sin_lon = rho > 0 ? p.y() / rho : 0;
  vertical.up_F = {cos_lat * cos_lon, cos_lat * sin_lon, sin_lat};
  vertical.height_m = rho * cos_lat + p.z() * sin_lat - a * std::sqrt(1 - e2 * sin_lat * sin_lat);
  return vertical;
}

}  // namespace

Vertical vertical(const Body& body, const Vec3& p_F_m) {
  if (body.flattening != 0) return vertical_on_ellipsoid(body, p_F_m);
  const double r = p_F_m.norm();
  LSOS_ASSERT(r > 0);
  return {p_F_m / r, r - body.equatorial_radius_m};
}

double gravity_mps2(const Body& body, double sin_lat, double height_m) {
  const double a = body.equatorial_radius_m;
  const double h = height_m;
  if (body.flattening == 0) return body.gm_m3ps2 / ((a + h) * (a + h));
  // Somigliana's formula with the constants of WGS84, and the free-air correction to second order
  // (Moritz 1980, Geodetic Reference System; NIMA TR8350.2, 4-1 and 4-3).
  constexpr double gamma_equator_mps2 = 9.7803253359;
  constexpr double k = 0.00193185265241;
  constexpr double m = 0.00344978650684;  // omega^2 a^2 b / GM
  const double f = body.flattening;
  const double e2 = f * (2 - f);
  const double s2 = sin_lat * sin_lat;
  const double surface = gamma_equator_mps2 * (1 + k * s2) / std::sqrt(1 - e2 * s2);
  return surface * (1 - 2 / a * (1 + f + m - 2 * f * s2) * h + 3 * h * h / (a * a));
}

Curvature curvature(const Body& body, double sin_lat) {
  const double e2 = body.flattening * (2 - body.flattening);
  const double w2 = 1 - e2 * sin_lat * sin_lat;
  const double normal_m = body.equatorial_radius_m / std::sqrt(w2);
  return {normal_m * (1 - e2) / w2, normal_m};
}

}  // namespace lsos
