#include "base/rotation_from_z.h"

namespace lsos {

Mat3 rotation_from_z(const Vec3& to) {
  return Quat::FromTwoVectors(Vec3::UnitZ(), to).toRotationMatrix();
}

}  // namespace lsos
