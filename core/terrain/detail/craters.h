// Craters: how many there are, how they degrade with age, and their shape.
#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include "terrain/detail/poisson_field.h"
#include "terrain/spec/terrain_spec.h"

namespace lsos {

struct Crater {
  PlanePoint centre;
  double diameter_m = 0;  // rim crest to rim crest
  double depth_m = 0;     // rim crest to floor
  double rim_m = 0;       // height of the crest above the ground around
};

inline constexpr double crater_reach = 3;  // outer radius of the ejecta, in crater radii
inline constexpr double bowl_share = 0.8;  // share of the radius at which the rounded crest begins

// Height of the bowl, r in 0..1: a parabola, and from bowl_share on a rounded crest. Free of
// branches, for long loops.
inline double crater_bowl_m(double r, double depth_m, double rim_m) {
  const double bowl_m = rim_m - depth_m + depth_m / bowl_share * r * r;
  const double crest_m = rim_m - depth_m / (1 - bowl_share) * (1 - r) * (1 - r);
  return r <= bowl_share ? bowl_m : crest_m;
}

// Height of the ejecta blanket, r in 1..crater_reach. Ejecta thin out as r^-3 (McGetchin et al.
// 1973); this polynomial follows that within a third of the rim height, is level at the crest and
// ends smoothly.
inline double crater_blanket_m(double r, double rim_m) {
  const double s = (crater_reach - r) / (crater_reach - 1);
  const double s2 = s * s;
  return rim_m * s2 * s2 * s * (6 - 5 * s);
}

// Height above the ground before the impact, at a distance of r radii from the centre: a parabolic
// bowl with a rounded rim, outside it an ejecta blanket that ends at `crater_reach` radii. C1.
inline double crater_height_m(double r, double depth_m, double rim_m) {
  if (r >= crater_reach) return 0;
  return r > 1 ? crater_blanket_m(r, rim_m) : crater_bowl_m(r, depth_m, rim_m);
}

// Derivative of crater_height_m() by r.
inline double crater_slope_m(double r, double depth_m, double rim_m) {
  if (r >= crater_reach) return 0;
  if (r > 1) {
    const double s = (crater_reach - r) / (crater_reach - 1), s2 = s * s;
    return -rim_m * 30 * s2 * s2 * (1 - s) / (crater_reach - 1);
  }
  return r <= bowl_share ? 2 * depth_m / bowl_share * r : 2 * depth_m / (1 - bowl_share) * (1 - r);
}

// Integral of crater_height_m() over the ground, m3, in closed form; negative where the bowl holds
// more than rim and blanket.
inline double crater_volume_m3(const Crater& crater) {
  const double radius_m = crater.diameter_m / 2;
  return std::numbers::pi * radius_m * radius_m *
         (18.0 / 7 * crater.rim_m - 61.0 / 150 * crater.depth_m);
}

// Rim height of a fresh simple crater by its depth: 0.036 D to 0.196 D (Pike 1977, Size-dependence
// in the shape of fresh impact craters on the Moon).
inline constexpr double rim_to_depth = 0.036 / 0.196;

// Craters per m2 larger than D that a lunar surface of that age has received: the production
// function and chronology of Neukum, Ivanov and Hartmann 2001 from 10 m to 100 km; below 10 m
// continued with the exponent -3, an assumption.
double crater_production_pm2(double age_gyr, double diameter_m);

// Craters per m2 larger than D that a surface can hold at most: 10^-1.1 D^-2 (Trask 1966).
double crater_equilibrium_pm2(double diameter_m);

// Craters per m2 of the population that are larger than D.
double cumulative_pm2(const CraterPopulation& population, double diameter_m);

// Expected volume of the craters with a diameter in [low_m, high_m), m3 per m2.
double crater_volume_pm2(const CraterPopulation& population, double low_m, double high_m);

// All craters with a diameter in [diameter_low_m, diameter_high_m) whose blanket may touch the
// rectangle, in a fixed order.
std::vector<Crater> craters_touching(const CraterPopulation& population, std::uint64_t seed,
                                     const PlaneRectangle& area, double diameter_low_m = 0,
                                     double diameter_high_m = 1e9);

}  // namespace lsos
