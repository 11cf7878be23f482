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
      p_FS_m_(lsos::p_F_m(body, origin)) {}

Vec3 SiteFrame::p_S_m(const Geodetic& place) const {
  return p_S_m_from_fixed(lsos::p_F_m(*body_, place));
}

Geodetic SiteFrame::geodetic(const Vec3& p_S_m) const {
  return lsos::geodetic(*body_, p_F_m(p_S_m));
}

Vec3 SiteFrame::from_centre_S_m(const Vec3& p_S_m) const {
  // On a sphere the centre lies straight below the origin, so no rotation is needed.
  return {p_S_m.x(), p_S_m.y(), p_S_m.z() + body_->equatorial_radius_m + origin_.height_m};
}

Vec3 SiteFrame::up_S(const Vec3& p_S_m) const {
  if (body_->flattening == 0) return from_centre_S_m(p_S_m).normalized();
  return R_FS_.transpose() * vertical(*body_, p_F_m(p_S_m)).up_F;
}

double SiteFrame::height_m(const Vec3& p_S_m) const {
  if (body_->flattening == 0) return from_centre_S_m(p_S_m).norm() - body_->equatorial_radius_m;
  return vertical(*body_, p_F_m(p_S_m)).height_m;
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
  if (body_->flattening == 0) {
    const Vec3 p = from_centre_S_m(p_S_m);
    const double r2 = p.squaredNorm();
    return p * (-body_->gm_m3ps2 / (r2 * std::sqrt(r2)));
  }
  const Vertical at = vertical(*body_, p_F_m(p_S_m));
  return R_FS_.transpose() * at.up_F * -gravity_mps2(*body_, at.up_F.z(), at.height_m);
}

}  // namespace lsos
