#include "planet/ellipsoid.h"

#include <cmath>

namespace lsos {

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

double curvature_radius_m(const Body& body, double sin_lat) {
  const double e2 = body.flattening * (2 - body.flattening);
  return body.equatorial_radius_m * (1 - body.flattening) / (1 - e2 * sin_lat * sin_lat);
}

double gravity_mps2(const Body& body, const Geodetic& place) {
  return gravity_mps2(body, std::sin(place.lat_rad), place.height_m);
}

}  // namespace lsos
