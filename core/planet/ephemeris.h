// Positions and velocities of Sun, Earth, Moon and Mars.
#pragma once

#include "base/vector.h"
#include "planet/utc.h"

namespace lsos {

enum class CelestialBody { sun, earth, moon, mars };

// State of a body's centre relative to the barycentre of the solar system, in ICRF axes.
struct BarycentricState {
  Vec3 p_I_m = Vec3::Zero();
  Vec3 v_I_mps = Vec3::Zero();
};

// Earth: VSOP2000 as fitted in ERFA's epv00 (Simon et al. 2001); Moon: ELP2000/82 in moon98
// (Chapront-Touze and Chapront 1988; Meeus 1998); Mars: plan94 (Simon et al. 1994). Errors of
// directions between them are at most 0.004 deg (Mars), of distances 2e-5 (relative); 1900..2100.
BarycentricState barycentric_state(CelestialBody body, Instant at);

// Radius of the body's disc, m: the Sun's photosphere (Prsa et al. 2016), else the mean radius.
double disc_radius_m(CelestialBody body);

// Days of TT since 2000-01-01T12:00 TT, which is also TDB to 2 ms.
double tt_days(Instant at);

}  // namespace lsos
