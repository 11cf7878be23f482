// Sunlight at a place: where the Sun is seen through the air, how strong its light is, and what sky
// and ground add to it.
#pragma once

#include "base/sim_time.h"
#include "planet/diffuse_light.h"
#include "planet/sky.h"

namespace lsos {

// Irradiance across the light there, without air: 1361 W/m2 at 1 au (Kopp and Lean 2011).
double irradiance_wpm2(double sun_distance_m);

// Air mass: how much more air a ray passes than one straight up from sea level (Kasten and Young
// 1989), reduced by height with a scale of 8.4 km. Apparent elevation, which counts as at least 0.
double air_mass(double elevation_rad, double height_m);
// Share of direct sunlight that clear air lets through: 0.7^(air mass^0.678) (Meinel and Meinel
// 1976). 0 below the horizon.
double clear_sky_share(double elevation_rad, double height_m);
// Share of direct sunlight that dust of a given vertical optical depth lets through: Beer's law
// over a level layer. Light that the dust scatters is not counted, see dusty_light().
double dusty_sky_share(double elevation_rad, double optical_depth);

struct Sunlight {
  SkyPosition seen;            // position of the disc's centre; on Earth raised by refraction
  double disc_rad = 0;         // angular radius
  double irradiance_wpm2 = 0;  // across direct light of the whole disc
  double eclipsed = 0;         // share of the disc that Earth covers, on the Moon
  double aureole_wpm2 = 0;     // across light that dust scatters forward, from around the disc
  double sky_wpm2 = 0;         // on level ground, from the whole sky but disc and aureole
  double ground_wpm2 = 0;      // reflected by level ground, on a surface that sees nothing else
};
// `optical_depth`: vertical optical depth of dust, on bodies other than Earth. `ground_albedo`:
// share of the light on it that the ground reflects. Sky and ground give no light once the middle
// of the disc is below the horizon: twilight, at most about 1 % of the light of noon, is left out.
Sunlight sunlight(const Body& on, const Geodetic& place, Instant at, double optical_depth,
                  double ground_albedo = 0);
// Light on level ground under a free sky: of disc, aureole and sky.
double level_wpm2(const Sunlight& light);

// Time that the Sun takes for Body::sun_step_deg of its way, in whole exchanges: how often it is
// looked at.
SimTime sun_interval(const Body& body);

// Unit, towards the middle of the disc, at a place of the site.
Vec3 direction_S(const SiteFrame& site, const Vec3& p_S_m, const SkyPosition& seen);

}  // namespace lsos
