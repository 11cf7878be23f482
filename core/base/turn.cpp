#include "base/turn.h"

namespace lsos {

Mat3 turn_of_z(const Vec3& to) {
  return Quat::FromTwoVectors(Vec3::UnitZ(), to).toRotationMatrix();
}

}  // namespace lsos
