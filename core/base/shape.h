// Solids, as plain values, that stand for an object in shadow computations and pictures.
#pragma once

#include <string>

#include "base/vector.h"

namespace lsos {

struct Shape {
  enum class Kind { box, cylinder };  // a cylinder's axis is its z

  Kind kind = Kind::box;
  Vec3 size_m = Vec3::Ones();    // along its own axes; cylinder: diameter, diameter, length
  Vec3 p_B_m = Vec3::Zero();     // centre: forward, left, up of the reference point, at rest
  Mat3 R_BL = Mat3::Identity();  // from its own axes to the body's, at rest
  std::string part;              // the link that it moves with; "": the chassis
  Vec3 colour = Vec3(0.75, 0.75, 0.75);  // red, green, blue, 0..1
};

}  // namespace lsos
