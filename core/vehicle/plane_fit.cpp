#include "vehicle/plane_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace lsos {

PlaneFit fit_plane(const std::vector<Vec3>& points, const Vec3& up) {
  const Vec3 u = up.unitOrthogonal(), v = up.cross(u);
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
  Vec2 b = Vec2::Zero();
  for (const Vec3& p : points) {
    const Vec2 at((p - mean).dot(u), (p - mean).dot(v));
    A += at * at.transpose();
    b += at * (p - mean).dot(up);
  }
  const Vec2 rise = A.determinant() > 0 ? Vec2(A.ldlt().solve(b)) : Vec2(Vec2::Zero());
  return {mean, (up - rise.x() * u - rise.y() * v).normalized()};
}

}  // namespace lsos
