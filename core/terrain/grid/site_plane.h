// Central projection of the body on the tangent plane of the site: the flat coordinates x (east)
// and y (north) in which ground is looked up. On a sphere it is the gnomonic projection.
#pragma once

#include "planet/site_frame.h"

namespace lsos {

struct PlanePoint {
  double x_m = 0;
  double y_m = 0;
};

// Position of a point of the site frame over the body.
struct ProjectedPoint {
  bool is_near = false;  // within 60 degrees of the site; all else holds only then
  PlanePoint at;         // projection of the point of the reference surface below it
  double height_m = 0;   // above the reference surface
  double radius_m = 0;   // radius of curvature at the point: that of the reference surface + height
  Vec3 up_S;             // local vertical, unit
  // Gradients of x and y in space at the point. Along the vertical they fall as 1/radius_m.
  Vec3 grad_x_S;
  Vec3 grad_y_S;
};

class SitePlane {
 public:
  explicit SitePlane(const SiteFrame& site);

  const SiteFrame& site() const { return site_; }

  ProjectedPoint projected(const Vec3& p_S_m) const;
  // The same with the vertical at the point already known.
  ProjectedPoint projected(const Vec3& p_S_m, const Vertical& vertical) const;
  // The place on the reference surface that projects to (x, y), and the reverse; the reverse must
  // lie within 60 degrees of the site.
  Geodetic place(const PlanePoint& at) const;
  PlanePoint at(const Geodetic& place) const;
  // Distance of the tangent plane from the body's centre: plane metres are true metres there.
  double distance_m() const { return distance_m_; }

 private:
  SiteFrame site_;
  double distance_m_;
  // Direction of the site's foot from the centre; zero on a sphere, where it is straight up.
  double x_per_z_ = 0;
  double y_per_z_ = 0;
};

}  // namespace lsos
