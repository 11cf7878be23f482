// The bodies we drive on: size, gravity, and the geographic reference system of their maps.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/vector.h"

namespace lsos {

// Frame F is fixed to the body: origin at its centre, z to the north pole, x to longitude 0.
struct Body {
  std::string_view name;       // as MissionInfo's Planet has it: "Moon", "Mars", "Earth"
  double equatorial_radius_m;  // of the reference surface of heights
  double flattening;           // 0: a sphere
  double gm_m3ps2;             // gravitational parameter
  std::string_view crs;        // geographic CRS of plans and logs: "IAU_2015:30100", ...
};

std::span<const Body> all_bodies();
// nullptr when there is no such body.
const Body* find_body(std::string_view name);

// East-positive longitude (-pi..pi), latitude, height above the reference surface. Planetocentric
// on Moon and Mars, WGS84 geodetic on Earth.
struct Geodetic {
  double lon_rad = 0;
  double lat_rad = 0;
  double height_m = 0;
};

double lon_deg(const Geodetic& place);
double lat_deg(const Geodetic& place);
Geodetic geodetic_from_degrees(double lon_deg, double lat_deg, double height_m = 0);

Vec3 p_F_m(const Body& body, const Geodetic& place);
Geodetic geodetic(const Body& body, const Vec3& p_F_m);

// Shortest distance along the reference surface (sphere: great circle; Earth: geodesic
// approximated to 0.5 %), m.
double surface_distance_m(const Body& body, const Geodetic& a, const Geodetic& b);

// Magnitude of gravity at that place, m/s2: GM/r^2 on Moon and Mars; WGS84 normal gravity with
// the free-air correction on Earth (Moritz 1980, Geodetic Reference System).
double gravity_mps2(const Body& body, const Geodetic& place);

}  // namespace lsos
