// Rotations from one direction to another.
#pragma once

#include "base/vector.h"

namespace lsos {

// The shortest rotation from the z axis to a direction of any length but 0. It has a file of its
// own because Eigen's code for it takes seconds to compile.
Mat3 rotation_from_z(const Vec3& to);

}  // namespace lsos
