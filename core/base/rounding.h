// Rounding of numbers in tables and JSON.
#pragma once

namespace lsos {

// Rounded to that many decimals, so that 0.3 is not written 0.30000000000000004.
double with_decimals(double value, int decimals);
// To 12 decimals, which removes the error of turning a user's degrees into radians and back.
double entered_deg(double angle_deg);
// A computed value to 9 decimals: 1e-9 degrees, 1e-9 of a share, or a nanometre.
double computed(double value);

}  // namespace lsos
