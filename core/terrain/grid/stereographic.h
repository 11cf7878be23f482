// Map that random landforms are drawn on: the sphere seen from the point opposite to a place, on
// the plane that touches it there. Conformal, so that round craters stay round; lengths grow by the
// share (distance / 2 radius)^2.
#pragma once

#include "planet/body.h"
#include "terrain/grid/site_plane.h"

namespace lsos {

class Stereographic {
 public:
  // Map of the sphere with the body's equatorial radius; on Earth latitudes are taken as they are.
  Stereographic(const Body& body, double lon_rad, double lat_rad);

  // Map coordinates of a place, and back: x east, y north at the centre, m.
  PlanePoint at(const Geodetic& place) const;
  Geodetic place(const PlanePoint& at) const;
  // The place as a unit vector in body-fixed axes, without trigonometry.
  Vec3 direction(const PlanePoint& at) const;

 private:
  double radius_m_;
  Mat3 R_;  // rows: east, north, up at the centre
};

}  // namespace lsos
