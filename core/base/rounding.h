// Numbers as answers give them.
#pragma once

namespace lsos {

// Rounded to that many decimals, so that 0.3 is not written 0.30000000000000004.
double with_decimals(double value, int decimals);
// A place as it was asked, without the digits of a turn into radians and back.
double entered_deg(double angle_deg);
// What was computed, to 1e-9 degrees, 1e-9 of a share, or a nanometre.
double computed(double value);

}  // namespace lsos
