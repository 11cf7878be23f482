#include "terrain/site_plane.h"

#include <cmath>

#include "planet/ellipsoid.h"

namespace lsos {

namespace {

constexpr double cos_farthest = 0.5;  // 60 degrees: x and y then still change with place by 1/4

}  // namespace

SitePlane::SitePlane(const SiteFrame& site)
    : site_(site), centre_to_site_S_m_(-site.p_S_m_from_fixed(Vec3::Zero())) {
  const Body& body = site.body();
  if (body.flattening == 0) {
    // Exactly as SiteFrame has it, without the rounding of a rotation there and back.
    centre_to_site_S_m_ = {0, 0, body.equatorial_radius_m + site.origin().height_m};
  }
  const Vec3 foot = centre_to_site_S_m_ - Vec3(0, 0, site.origin().height_m);
  x_per_z_ = foot.x() / foot.z();
  y_per_z_ = foot.y() / foot.z();
  distance_m_ = centre_to_site_S_m_.z();
}

Standing SitePlane::standing(const Vec3& p_S_m) const {
  return site_.body().flattening == 0 ? standing_on_sphere(p_S_m) : standing_on_ellipsoid(p_S_m);
}

Standing SitePlane::standing_on_sphere(const Vec3& p_S_m) const {
  Standing result;
  const Vec3 p = p_S_m + centre_to_site_S_m_;
  const double r = p.norm();
  if (!(p.z() > cos_farthest * r)) return result;
  result.is_near = true;
  result.radius_m = r;
  // r - R without the digits that a difference of two radii loses: wheels would feel them.
  const double R = site_.body().equatorial_radius_m, c = centre_to_site_S_m_.norm();
  const double over_site_m = (p_S_m.squaredNorm() + 2 * p_S_m.dot(centre_to_site_S_m_)) / (r + c);
  result.height_m = over_site_m + (c - R);
  result.up_S = p * (1 / r);
  const double per_z = 1 / p.z();
  const double scale = distance_m_ * per_z;
  result.at = {p.x() * scale, p.y() * scale};
  result.grad_x_S = {scale, 0, -result.at.x_m * per_z};
  result.grad_y_S = {0, scale, -result.at.y_m * per_z};
  return result;
}

Standing SitePlane::standing_on_ellipsoid(const Vec3& p_S_m) const {
  Standing result;
  const Mat3& R_FS = site_.R_FS();
  const Vertical vertical = lsos::vertical(site_.body(), site_.p_F_m(p_S_m));
  result.up_S = R_FS.transpose() * vertical.up_F;
  result.height_m = vertical.height_m;
  const Vec3 foot = p_S_m + centre_to_site_S_m_ - vertical.height_m * result.up_S;
  if (!(foot.z() > cos_farthest * foot.norm())) return result;
  result.is_near = true;
  const double x_per_z = foot.x() / foot.z();
  const double y_per_z = foot.y() / foot.z();
  result.at = {distance_m_ * (x_per_z - x_per_z_), distance_m_ * (y_per_z - y_per_z_)};

  // The foot moves less than the point above it: by M/(M + h) northwards, N/(N + h) eastwards.
  const Curvature radius = curvature(site_.body(), vertical.up_F.z());
  result.radius_m = radius.normal_m + vertical.height_m;
  const Vec3 east_S = site_.east_S(p_S_m);
  const Vec3 north_S = result.up_S.cross(east_S);
  const double north = radius.meridian_m / (radius.meridian_m + vertical.height_m);
  const double east = radius.normal_m / (radius.normal_m + vertical.height_m);
  const double scale = distance_m_ / foot.z();
  const auto at_point = [&](const Vec3& at_foot) -> Vec3 {
    return east * east_S.dot(at_foot) * east_S + north * north_S.dot(at_foot) * north_S;
  };
  result.grad_x_S = at_point({scale, 0, -scale * x_per_z});
  result.grad_y_S = at_point({0, scale, -scale * y_per_z});
  return result;
}

Geodetic SitePlane::place(const PlanePoint& at) const {
  const Vec3 ray_S(at.x_m / distance_m_ + x_per_z_, at.y_m / distance_m_ + y_per_z_, 1);
  const Body& body = site_.body();
  const Vec3 ray_F = site_.R_FS() * ray_S;
  const double polar_m = body.equatorial_radius_m * (1 - body.flattening);
  const double length = 1 / std::hypot(std::hypot(ray_F.x(), ray_F.y()) / body.equatorial_radius_m,
                                       ray_F.z() / polar_m);
  Geodetic place = lsos::geodetic(body, length * ray_F);
  place.height_m = 0;
  return place;
}

PlanePoint SitePlane::at(const Geodetic& place) const {
  return standing(site_.p_S_m({place.lon_rad, place.lat_rad, 0})).at;
}

}  // namespace lsos
