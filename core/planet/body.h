// The bodies that rovers drive on: size, gravity, and geographic reference system of their maps.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/vector.h"

namespace lsos {

enum class BodyId { moon, mars, earth, other };
enum class Air { none, dusty, clear };

// Frame F is fixed to the body: origin at its centre, z to the north pole, x to longitude 0.
struct Body {
  BodyId id = BodyId::other;
  std::string_view name;           // as MissionInfo's Planet has it: "Moon", "Mars", "Earth"
  double equatorial_radius_m = 0;  // of the reference surface of heights
  double flattening = 0;           // 0: a sphere
  double gm_m3ps2 = 0;             // gravitational parameter
  std::string_view crs;            // geographic CRS of plans and logs: "IAU_2015:30100", ...
  std::string_view north_polar_crs, south_polar_crs;  // of maps about its poles
  double rotation_radps = 0;                          // sidereal
  double solar_day_s = 0;                             // mean
  // Between two looks at the Sun it moves by this, and between two at Earth that long passes.
  double sun_step_deg = 0, earth_interval_s = 0;
  double lowest_ground_m = 0, highest_ground_m = 0;  // above the reference surface
  Air air = Air::none;
  // Where a terrain script says nothing: vertical optical depth of dust, and share of light that
  // the ground reflects. 0 on the Moon: a panel there sees its reflected light as less than 1 % of
  // the Sun's where rovers follow it near a pole, and ground in shadow would give it too.
  double assumed_optical_depth = 0, assumed_albedo = 0;
  std::string_view assumed_soil;  // of ground of which nothing says what it is made of
};

std::span<const Body> all_bodies();
// Returns nullptr when there is no such body.
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

// Shortest distance along the reference surface, m: a great circle; on Earth by Lambert's formula,
// which leaves out the square of the flattening.
double surface_distance_m(const Body& body, const Geodetic& a, const Geodetic& b);

}  // namespace lsos
