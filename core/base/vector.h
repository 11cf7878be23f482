// Vectors and rotations. Names carry the frame: p_S_m is a position in the site frame S in metres;
// R_SB rotates vectors of the body frame B into S. See core/README.md for the letters.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <vector>

namespace lsos {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;
using Path3 = std::vector<Vec3>;

// Stands for a quantity that is not modelled; written to the log as NULL.
inline constexpr double not_modelled = std::numeric_limits<double>::quiet_NaN();

}  // namespace lsos
