// Heights of a crater along a line of equidistant points: where synthetic ground spends its time.
#pragma once

#include "terrain/detail/craters.h"

namespace lsos {

// Point i, in crater radii from the crater's centre: (x + i x_step, y + i y_step).
struct CraterLine {
  double x = 0, y = 0;
  double x_step = 0, y_step = 0;
};

// Adds crater_height_m() to the heights of points low..high of the line, none of them farther than
// crater_reach; none when high < low. Their first is heights_m[low].
void add_crater(double* heights_m, int low, int high, const CraterLine& line, double depth_m,
                double rim_m);

}  // namespace lsos
