// Orientation of a body: rotation from ICRF axes to those fixed to it (frame F of body.h).
#pragma once

#include "planet/body.h"
#include "planet/utc.h"

namespace lsos {

// Rotation matrix from ICRF axes to body-fixed axes. Moon and Mars: series of the IAU working group
// (Archinal et al. 2011 for the Moon's mean Earth axes, good to 0.005 deg; Archinal et al. 2018 for
// Mars). Earth: IAU 2000B precession and nutation and the Earth rotation angle, with UT1 = UTC, an
// error of 0.9 s or 0.004 deg at most.
Mat3 R_FI(const Body& body, Instant at);

}  // namespace lsos
