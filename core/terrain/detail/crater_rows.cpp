#include "terrain/detail/crater_rows.h"

#include <algorithm>
#include <cmath>

// Loops handle four points at a time where the processor can. Without contraction to fused
// operations each point gets the same bits on any processor.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LSOS_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define LSOS_WIDE
#endif

namespace lsos {

namespace {

LSOS_WIDE void add_bowl(double* heights_m, int low, int high, const CraterLine& line,
                        double depth_m, double rim_m) {
  const CraterLine at = line;
  for (int i = low; i <= high; ++i) {
    const double x = at.x + at.x_step * i, y = at.y + at.y_step * i;
    heights_m[i] += crater_bowl_m(std::sqrt(x * x + y * y), depth_m, rim_m);
  }
}

LSOS_WIDE void add_blanket(double* heights_m, int low, int high, const CraterLine& line,
                           double rim_m) {
  const CraterLine at = line;
  for (int i = low; i <= high; ++i) {
    const double x = at.x + at.x_step * i, y = at.y + at.y_step * i;
    heights_m[i] += crater_blanket_m(std::sqrt(x * x + y * y), rim_m);
  }
}

}  // namespace

void add_crater(double* heights_m, int low, int high, const CraterLine& line, double depth_m,
                double rim_m) {
  if (high < low) return;
  const double growth = line.x_step * line.x_step + line.y_step * line.y_step;
  const double across = line.x_step * line.y - line.y_step * line.x;
  const double left = 1 - across * across / growth;  // squared half chord of the rim's circle
  if (left <= 0) return add_blanket(heights_m, low, high, line, rim_m);
  const double nearest = -(line.x_step * line.x + line.y_step * line.y) / growth;
  const double half = std::sqrt(left / growth);
  const double first = std::ceil(nearest - half), last = std::floor(nearest + half);
  const int bowl_low = static_cast<int>(std::clamp<double>(first, low, high + 1));
  const int bowl_high = static_cast<int>(std::clamp<double>(last, low - 1, high));
  add_blanket(heights_m, low, std::min(high, bowl_low - 1), line, rim_m);
  add_bowl(heights_m, bowl_low, bowl_high, line, depth_m, rim_m);
  add_blanket(heights_m, std::max({low, bowl_low, bowl_high + 1}), high, line, rim_m);
}

}  // namespace lsos
