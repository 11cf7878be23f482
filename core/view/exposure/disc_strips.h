// The disc of the Sun cut into vertical strips, to tell how much of it stands above a horizon.
#pragma once

#include <algorithm>
#include <array>

namespace lsos {

// A strip is taken as the rectangle of its width and area.
struct DiscStrip {
  double azimuth_rad = 0;  // of its middle, from that of the disc's middle
  double half_rad = 0;     // half its height
};

// Strips of equal area. The horizon is taken as level across each: five err by less than 1 % of
// the disc.
inline constexpr int disc_strips_count = 5;
std::array<DiscStrip, disc_strips_count> disc_strips(double sun_rad, double disc_rad);

// Share of the strip above a horizon of that elevation, 0..1.
inline double seen_share(const DiscStrip& strip, double sun_rad, double horizon_rad) {
  return std::clamp((sun_rad + strip.half_rad - horizon_rad) / (2 * strip.half_rad), 0.0, 1.0);
}

}  // namespace lsos
