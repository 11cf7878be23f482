// The caption of a picture for a briefing: some lines of text and a scale bar.
#pragma once

#include <string>
#include <vector>

#include "picture/lettering.h"

namespace lsos {

struct Caption {
  std::string title;
  std::vector<std::string> lines;
  double metres_per_pixel = 0;  // for the scale bar; 0: none
  std::string scale_where;      // "at the rover"
};

// The greatest length of the series 1, 2, 5 times a power of ten, m, that is not above `most_m`.
double round_length_m(double most_m);

// Drawn over the lower edge; the size of letters is proportional to the picture's height.
void add_caption(const RgbCanvas& canvas, const Caption& caption, Lettering& letters);

}  // namespace lsos
