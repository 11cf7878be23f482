#include "terrain/grid/stereographic.h"

#include <cmath>

namespace lsos {

namespace {

Vec3 unit_vector(double lon_rad, double lat_rad) {
  const double cos_lat = std::cos(lat_rad);
  return {cos_lat * std::cos(lon_rad), cos_lat * std::sin(lon_rad), std::sin(lat_rad)};
}

}  // namespace

Stereographic::Stereographic(const Body& body, double lon_rad, double lat_rad)
    : radius_m_(body.equatorial_radius_m) {
  const Vec3 up = unit_vector(lon_rad, lat_rad);
  const Vec3 east(-std::sin(lon_rad), std::cos(lon_rad), 0);
  R_.row(0) = east;
  R_.row(1) = up.cross(east);
  R_.row(2) = up;
}

PlanePoint Stereographic::at(const Geodetic& place) const {
  const Vec3 p = R_ * unit_vector(place.lon_rad, place.lat_rad);
  const double k = 2 * radius_m_ / (1 + p.z());
  return {k * p.x(), k * p.y()};
}

Vec3 Stereographic::direction(const PlanePoint& at) const {
  const double x = at.x_m / (2 * radius_m_), y = at.y_m / (2 * radius_m_);
  const double r2 = x * x + y * y;
  return R_.transpose() * Vec3(2 * x, 2 * y, 1 - r2) / (1 + r2);
}

Geodetic Stereographic::place(const PlanePoint& at) const {
  const Vec3 p = direction(at);
  return {std::atan2(p.y(), p.x()), std::atan2(p.z(), std::hypot(p.x(), p.y())), 0};
}

}  // namespace lsos
