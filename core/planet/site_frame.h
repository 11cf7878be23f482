// The frame S that everything moves in: east-north-up at one place, fixed to the body. The ground
// curves away below its tangent plane, and "up" tilts with distance.
#pragma once

#include "planet/body.h"

namespace lsos {

class SiteFrame {
 public:
  // Origin on the reference surface at `origin` raised by its height.
  SiteFrame(const Body& body, const Geodetic& origin);

  const Body& body() const { return *body_; }
  const Geodetic& origin() const { return origin_; }

  Vec3 p_S_m(const Geodetic& place) const;
  Geodetic geodetic(const Vec3& p_S_m) const;

  // Unit vector along the local vertical at p (radial on Moon and Mars, ellipsoid normal on
  // Earth), and height above the reference surface. Cheap: no trigonometry on a sphere.
  Vec3 up_S(const Vec3& p_S_m) const;
  double height_m(const Vec3& p_S_m) const;

  // Local true north and east at p, unit, horizontal there.
  Vec3 north_S(const Vec3& p_S_m) const;
  Vec3 east_S(const Vec3& p_S_m) const;

  // Gravity at p: along -up_S.
  Vec3 gravity_S_mps2(const Vec3& p_S_m) const;

  // Body-fixed coordinates and back.
  Vec3 p_F_m(const Vec3& p_S_m) const { return p_FS_m_ + R_FS_ * p_S_m; }
  Vec3 p_S_m_from_fixed(const Vec3& p_F_m) const { return R_FS_.transpose() * (p_F_m - p_FS_m_); }
  const Mat3& R_FS() const { return R_FS_; }

 private:
  // On a sphere only: from the body's centre to p.
  Vec3 from_centre_S_m(const Vec3& p_S_m) const;

  const Body* body_;
  Geodetic origin_;
  Mat3 R_FS_;
  Vec3 p_FS_m_;
};

}  // namespace lsos
