// Heights of a crater along a line of equidistant points. Synthetic ground spends most time here.
#pragma once

#include "terrain/detail/craters.h"

namespace lsos {

// Line of points; point i, in crater radii from the centre, is (x + i x_step, y + i y_step).
struct CraterLine {
  double x = 0, y = 0;
  double x_step = 0, y_step = 0;
};

// Adds crater_height_m() to heights_m[low..high], the heights of points low..high of the line;
// nothing when high < low. No point may be farther than crater_reach.
void add_crater(double* heights_m, int low, int high, const CraterLine& line, double depth_m,
                double rim_m);

}  // namespace lsos
