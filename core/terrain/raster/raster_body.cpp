#include "terrain/raster/raster_body.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "terrain/raster/gdal_call.h"

namespace lsos {

namespace {

// Maps of one body use radii that differ a little: the Moon's 1737400 and 1738000 m, Mars's
// 3396190 and, for polar maps, 3376200 m. Two bodies of all_bodies() never come this near.
constexpr double radius_tolerance = 0.0065;

double semi_major_m(const OGRSpatialReference& crs, const RasterName& name) {
  OGRErr error = OGRERR_NONE;
  const double axis_m = crs.GetSemiMajor(&error);
  if (error != OGRERR_NONE || !(axis_m > 0)) {
    name.refuse("has a coordinate reference system that does not say how large its body is");
  }
  return axis_m;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Name of the body in the CRS, its geographic base or its datum: "GCS_Phobos", "D_Titan", ...
std::string name_in(const OGRSpatialReference& crs) {
  constexpr std::array names{"Mercury", "Venus",    "Phobos",   "Deimos",  "Ceres",   "Vesta",
                             "Europa",  "Ganymede", "Callisto", "Io",      "Titan",   "Enceladus",
                             "Dione",   "Rhea",     "Tethys",   "Iapetus", "Mimas",   "Triton",
                             "Charon",  "Pluto",    "Bennu",    "Ryugu",   "Itokawa", "Eros",
                             "Jupiter", "Saturn",   "Uranus",   "Neptune", "Sun"};
  std::string text;
  for (const char* node : {"PROJCS", "GEOGCS", "DATUM", "SPHEROID"}) {
    const char* value = crs.GetAttrValue(node);
    if (value != nullptr) text += lower(value) + " ";
  }
  // Only whole words count: "Io" is part of many.
  std::ranges::replace_if(
      text, [](unsigned char c) { return std::isalpha(c) == 0; }, ' ');
  for (const char* name : names) {
    if ((" " + text + " ").find(" " + lower(name) + " ") != std::string::npos) return name;
  }
  return "another body";
}

}  // namespace

MapBody body_of(const OGRSpatialReference& crs, const RasterName& name) {
  const GdalSilence silence;
  const double axis_m = semi_major_m(crs, name);
  for (const Body& body : all_bodies()) {
    if (is_radius_of(body, axis_m)) return {std::string(body.name), body};
  }
  Body other;
  other.equatorial_radius_m = axis_m;
  return {name_in(crs), other};
}

void check_body(const OGRSpatialReference& crs, const Body& body, const RasterName& name) {
  const GdalSilence silence;
  const double axis_m = semi_major_m(crs, name);
  if (is_radius_of(body, axis_m)) return;
  name.refuse(fmt::format("lies on {} (semi-major axis {} m), the site on {} ({} m)",
                          body_of(crs, name).name, axis_m, body.name, body.equatorial_radius_m));
}

bool is_radius_of(const Body& body, double length_m) {
  return std::abs(length_m / body.equatorial_radius_m - 1) < radius_tolerance;
}

// The greatest distances are Olympus Mons (21.2 km, Smith et al. 2001) and the poles of Mars seen
// from its equatorial sphere (-20 km). Small bodies are lumps.
double ground_limit_m(const Body& body) { return std::min(25e3, 0.5 * body.equatorial_radius_m); }

}  // namespace lsos
