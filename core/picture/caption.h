// What stands below a picture for a briefing: some lines of text, and a scale bar.
#pragma once

#include <string>
#include <vector>

#include "picture/lettering.h"

namespace lsos {

struct Caption {
  std::string title;
  std::vector<std::string> lines;
  double metres_a_pixel = 0;  // of the scale; 0: none
  std::string scale_where;    // "at the rover"
};

// The longest of 1, 2, 5, 10, 20, ... m, or 0.1 m and so on, that is no longer than that.
double round_length_m(double most_m);

// Over the lower edge, in letters that go with the picture's height.
void add_caption(const RgbCanvas& canvas, const Caption& caption, Lettering& letters);

}  // namespace lsos
