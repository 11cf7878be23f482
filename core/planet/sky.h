// Sun and Earth in the sky of a place: direction, angular size, distance.
#pragma once

#include <optional>

#include "planet/ephemeris.h"
#include "planet/site_frame.h"

namespace lsos {

// Apparent direction and size of a body, as a camera at a point of another body sees it: light
// time, aberration and the Sun's bending of light are counted, air is not.
struct Sighting {
  Vec3 direction_F = Vec3::UnitX();  // unit
  // Length of the light's path from the body's centre, in barycentric axes at rest; between Moon
  // and Earth in axes that move with Earth, in which neither has moved much meanwhile.
  double distance_m = 0;
  double disc_rad = 0;  // angular radius
};
// Sighting of `target` from the point `p_F_m`, in axes fixed to `on`.
Sighting sighting(const Body& on, const Vec3& p_F_m, CelestialBody target, Instant at);

// Share (0..1) of a disc that another one covers. Angular radii and separation of centres, rad.
double covered_share(double disc_rad, double cover_rad, double separation_rad);

// Share of the Sun's disc that Earth covers, seen from a point of the Moon.
double eclipsed_share(const Body& moon, const Vec3& p_F_m, const Sighting& sun, Instant at);

// Direction in the sky of a place. Azimuth 0..2 pi, clockwise from true north; elevation of the
// disc's centre above the plane across the local vertical.
struct SkyPosition {
  double azimuth_rad = 0;
  double elevation_rad = 0;
};
SkyPosition sky_position(const Body& on, const Geodetic& place, const Vec3& direction_F);

// Refraction: how much air raises an object of that true elevation, rad. Saemundsson 1986 (a fit to
// Bennett 1982 within 0.07', whose own error is 0.1') at the pressure and temperature of the
// standard atmosphere at that height; below -1 deg it falls to 0 at the nadir, an assumption.
double refraction_rad(double elevation_rad, double height_m);

// Sun and Earth in the sky of a place at a moment; what does not apply is absent.
struct Sky {
  SkyPosition sun;
  double sun_distance_m = 0;
  double sun_disc_rad = 0;                  // angular radius
  std::optional<double> sun_refracted_rad;  // elevation, on Earth
  Geodetic sub_solar;                       // where the Sun stands in the zenith; height 0
  std::optional<double> eclipsed;           // share of the disc that Earth covers, on the Moon
  std::optional<SkyPosition> earth;         // not on Earth
  std::optional<double> earth_distance_m;
};
Sky sky(const Body& on, const Geodetic& place, Instant at);

}  // namespace lsos
