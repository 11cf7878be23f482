#include "terrain/grid/site_plane.h"

#include <cmath>

#include "planet/ellipsoid.h"

namespace lsos {

namespace {

constexpr double cos2_farthest = 0.25;  // 60 degrees: a metre of x or y is then 1/4 m of ground

}  // namespace

SitePlane::SitePlane(const SiteFrame& site) : site_(site) {
  const Vec3 foot_m = site.centre_to_site_S_m() - Vec3(0, 0, site.origin().height_m);
  x_per_z_ = foot_m.x() / foot_m.z();
  y_per_z_ = foot_m.y() / foot_m.z();
  distance_m_ = site.centre_to_site_S_m().z();
}

ProjectedPoint SitePlane::projected(const Vec3& p_S_m) const {
  return projected(p_S_m, site_.vertical(p_S_m));
}

ProjectedPoint SitePlane::projected(const Vec3& p_S_m, const Vertical& vertical) const {
  ProjectedPoint result;
  const Vec3& up_S = result.up_S = vertical.up_S;
  const double height_m = result.height_m = vertical.height_m;
  const Vec3 foot_m = p_S_m + site_.centre_to_site_S_m() - height_m * up_S;
  const double z_m = foot_m.z();
  if (!(z_m > 0 && z_m * z_m > cos2_farthest * foot_m.squaredNorm())) return result;
  result.is_near = true;
  const double per_z = 1 / z_m, scale = distance_m_ * per_z;
  const double x_m = foot_m.x() * scale, y_m = foot_m.y() * scale;
  result.at = {x_m - distance_m_ * x_per_z_, y_m - distance_m_ * y_per_z_};

  // The foot moves less than the point above it, by R/(R + h). On an ellipsoid R is less along the
  // meridian than across it, by the share e^2 cos^2 of the latitude.
  const Body& body = site_.body();
  const double sin_lat = site_.sin_latitude(up_S);
  const double radius_m = curvature_radius_m(body, sin_lat);
  result.radius_m = radius_m + height_m;
  const double per_radius = 1 / result.radius_m;
  const double e2 = body.flattening * (2 - body.flattening);
  const double less = e2 * height_m * per_radius;
  const double share = radius_m * per_radius + less * (1 - sin_lat * sin_lat) / 2;
  const Vec3 north_S = site_.axis_S() - sin_lat * up_S;  // its length is the cosine of the latitude
  const auto at_point = [&](const Vec3& at_foot_S) -> Vec3 {
    const Vec3 level_S = at_foot_S - at_foot_S.dot(up_S) * up_S;
    return share * level_S - less * at_foot_S.dot(north_S) * north_S;
  };
  result.grad_x_S = at_point({scale, 0, -x_m * per_z});
  result.grad_y_S = at_point({0, scale, -y_m * per_z});
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
  return projected(site_.p_S_m({place.lon_rad, place.lat_rad, 0})).at;
}

}  // namespace lsos
