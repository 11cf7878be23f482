// Where and how finely tests of vehicles run.
#pragma once

#include "planet/site_frame.h"

namespace lsos::test {

inline constexpr double moon_g_mps2 = 1.6242;  // GM / R^2
inline constexpr double period_s = 0.1;
inline const Geodetic start_place{0.1, 0.2, 0};

}  // namespace lsos::test
