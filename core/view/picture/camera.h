// A pinhole camera without roll.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/vector.h"

namespace lsos {

// `ahead_S` and `up_S` are unit vectors at right angles in the site frame.
struct Camera {
  Vec3 eye_S_m = Vec3::Zero();
  Vec3 ahead_S = Vec3::UnitX();
  Vec3 up_S = Vec3::UnitZ();  // up in the picture
  int width_px = 1280, height_px = 720;
  double focal_px = 1000;

  Vec3 right_S() const { return ahead_S.cross(up_S); }
  double metres_per_pixel(double distance_m) const { return distance_m / focal_px; }
};

inline double focal_of(int width_px, double width_rad) {
  return width_px / 2.0 / std::tan(width_rad / 2);
}

// A camera at the eye that points at the target. `up_S` is the approximate up direction of the
// picture and must not be parallel to the line of sight.
inline Camera camera_towards(const Vec3& eye_S_m, const Vec3& target_S_m, const Vec3& up_S) {
  Camera camera;
  camera.eye_S_m = eye_S_m;
  camera.ahead_S = (target_S_m - eye_S_m).normalized();
  camera.up_S = (up_S - up_S.dot(camera.ahead_S) * camera.ahead_S).normalized();
  return camera;
}

}  // namespace lsos
