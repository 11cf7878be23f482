// The frame S that everything moves in: east-north-up at one place, fixed to the body. The ground
// curves away below its tangent plane, and "up" tilts with distance.
#pragma once

#include <cmath>

#include "planet/body.h"

namespace lsos {

// Unit vector along the local vertical (radial on Moon and Mars, ellipsoid normal on Earth), and
// height above the reference surface.
struct Vertical {
  Vec3 up_S = Vec3::UnitZ();
  double height_m = 0;
};

class SiteFrame {
 public:
  // Places the origin at `origin`, its height above the reference surface included.
  SiteFrame(const Body& body, const Geodetic& origin);

  const Body& body() const { return *body_; }
  const Geodetic& origin() const { return origin_; }

  Vec3 p_S_m(const Geodetic& place) const;
  Geodetic geodetic(const Vec3& p_S_m) const;

  // Uses no trigonometry and no difference of two radii, whose lost digits wheels would feel. On an
  // ellipsoid exact to 1e-9 rad and 1e-8 m within 10 km of its surface (1e-7 at 100 km).
  Vertical vertical(const Vec3& p_S_m) const;
  Vec3 up_S(const Vec3& p_S_m) const { return vertical(p_S_m).up_S; }
  double height_m(const Vec3& p_S_m) const { return vertical(p_S_m).height_m; }
  // Sine of the latitude whose vertical is `up_S`.
  double sin_latitude(const Vec3& up_S) const { return up_S.dot(axis_S_); }

  // Unit vectors to local true north and east at p, horizontal there.
  Vec3 north_S(const Vec3& p_S_m) const;
  Vec3 east_S(const Vec3& p_S_m) const;
  // Azimuth of a direction at p, -pi..pi clockwise from true north there.
  double azimuth_rad(const Vec3& direction_S, const Vec3& p_S_m) const {
    return std::atan2(direction_S.dot(east_S(p_S_m)), direction_S.dot(north_S(p_S_m)));
  }
  // Horizontal unit vector at p in an azimuth, clockwise from true north there.
  Vec3 horizontal_S(double azimuth_rad, const Vec3& p_S_m) const {
    return std::cos(azimuth_rad) * north_S(p_S_m) + std::sin(azimuth_rad) * east_S(p_S_m);
  }

  // Gravity at p, along -up_S.
  Vec3 gravity_S_mps2(const Vec3& p_S_m) const;

  // Body-fixed coordinates and back.
  Vec3 p_F_m(const Vec3& p_S_m) const { return p_FS_m_ + R_FS_ * p_S_m; }
  Vec3 p_S_m_from_fixed(const Vec3& p_F_m) const { return R_FS_.transpose() * (p_F_m - p_FS_m_); }
  const Mat3& R_FS() const { return R_FS_; }
  const Vec3& axis_S() const { return axis_S_; }  // unit, axis of rotation, towards north
  // Vector from the body's centre to the origin.
  const Vec3& centre_to_site_S_m() const { return centre_to_site_S_m_; }

 private:
  // The reference surface is where p'Ap = a^2 with A = I + stretch * axis axis', p from the centre.
  Vec3 times_A(const Vec3& v_S) const { return v_S + stretch_ * v_S.dot(axis_S_) * axis_S_; }

  const Body* body_;
  Geodetic origin_;
  Mat3 R_FS_;
  Vec3 p_FS_m_;
  Vec3 axis_S_;
  double stretch_;
  Vec3 centre_to_site_S_m_;
  Vec3 site_gradient_m_;   // A p at the origin
  double site_excess_m2_;  // p'Ap - a^2 at the origin
};

}  // namespace lsos
