#include "planet/site_frame.h"

#include <cmath>

#include "planet/ellipsoid.h"

namespace lsos {

namespace {

// Columns: east, north, up at the place, in F.
Mat3 east_north_up(const Geodetic& place) {
  const double sin_lon = std::sin(place.lon_rad);
  const double cos_lon = std::cos(place.lon_rad);
  const double sin_lat = std::sin(place.lat_rad);
  const double cos_lat = std::cos(place.lat_rad);
  Mat3 R_FS;
  R_FS.col(0) = Vec3(-sin_lon, cos_lon, 0);
  R_FS.col(1) = Vec3(-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat);
  R_FS.col(2) = Vec3(cos_lat * cos_lon, cos_lat * sin_lon, sin_lat);
  return R_FS;
}

}  // namespace

SiteFrame::SiteFrame(const Body& body, const Geodetic& origin)
    : body_(&body),
      origin_(origin),
      R_FS_(east_north_up(origin)),
      p_FS_m_(lsos::p_F_m(body, origin)),
      axis_S_(R_FS_.row(2)),
      centre_to_site_S_m_(R_FS_.transpose() * p_FS_m_) {
  const double f = body.flattening, h = origin.height_m;
  stretch_ = f * (2 - f) / ((1 - f) * (1 - f));
  // On a sphere the vector is exact, without the rounding of a rotation and its inverse.
  if (f == 0) centre_to_site_S_m_ = {0, 0, body.equatorial_radius_m + h};
  site_gradient_m_ = times_A(centre_to_site_S_m_);
  site_excess_m2_ = h * (2 * site_gradient_m_.z() - h * times_A(Vec3::UnitZ()).z());
}

Vec3 SiteFrame::p_S_m(const Geodetic& place) const {
  return p_S_m_from_fixed(lsos::p_F_m(*body_, place));
}

Geodetic SiteFrame::geodetic(const Vec3& p_S_m) const {
  return lsos::geodetic(*body_, p_F_m(p_S_m));
}

// The foot f of the vertical through p solves p = (1 + tA) f, f'Af = a^2, so that up = Af/|Af| lies
// along p + s (p axis') axis with 1 + s = (1 + stretch)(1 + t) / (1 + t + t stretch). With
// tau = (p'Ap - a^2) / 2 p'A^2p, t = (1 - 2 tau)^(-1/2) - 1 on a sphere, which leaves an error of
// stretch tau^2 in t and of stretch^2 tau^2 in up. The height along up is exact: the root of
// (p - h up)'A(p - h up) = a^2. The excess p'Ap - a^2 is computed from the origin's, so that no
// large numbers cancel.
Vertical SiteFrame::vertical(const Vec3& p_S_m) const {
  const Vec3 p_m = p_S_m + centre_to_site_S_m_;
  const Vec3 from_origin_m = times_A(p_S_m);
  const double excess_m2 = site_excess_m2_ + p_S_m.dot(2 * site_gradient_m_ + from_origin_m);
  if (stretch_ == 0) {
    const double r_m = p_m.norm();
    return {p_m * (1 / r_m), excess_m2 / (r_m + body_->equatorial_radius_m)};
  }
  const Vec3 gradient_m = site_gradient_m_ + from_origin_m;
  const double tau = excess_m2 / (2 * gradient_m.squaredNorm());
  const double t = tau * (1 + tau * (1.5 + tau * 2.5));
  const double s = stretch_ / (1 + t * (1 + stretch_));
  const Vec3 along_m = p_m + s * p_m.dot(axis_S_) * axis_S_;
  Vertical vertical;
  vertical.up_S = along_m * (1 / along_m.norm());
  const double sin_lat = sin_latitude(vertical.up_S);
  const double B_m = gradient_m.dot(vertical.up_S), C = 1 + stretch_ * sin_lat * sin_lat;
  vertical.height_m = excess_m2 / (B_m + std::sqrt(B_m * B_m - C * excess_m2));
  return vertical;
}

Vec3 SiteFrame::east_S(const Vec3& p_S_m) const {
  const Vec3 p = p_F_m(p_S_m);
  const double rho = std::hypot(p.x(), p.y());
  // At a pole every direction is north (or south); the meridian of longitude 0 is taken.
  const Vec3 east_F = rho > 0 ? Vec3(-p.y() / rho, p.x() / rho, 0) : Vec3::UnitY();
  return R_FS_.transpose() * east_F;
}

Vec3 SiteFrame::north_S(const Vec3& p_S_m) const { return up_S(p_S_m).cross(east_S(p_S_m)); }

Vec3 SiteFrame::gravity_S_mps2(const Vec3& p_S_m) const {
  const Vertical at = vertical(p_S_m);
  return at.up_S * -gravity_mps2(*body_, sin_latitude(at.up_S), at.height_m);
}

}  // namespace lsos
