// Charts as SVG text: panels side by side under one legend, with ticks at round numbers.
#pragma once

#include <string>
#include <vector>

namespace lsos::validation {

enum class Draw { line, dashed, markers };

struct ChartPoint {
  double x = 0, y = 0;
  double spread = 0;  // height of a bar through the marker; 0: none
};

struct Series {
  std::string label;
  Draw draw = Draw::line;
  int colour = 0;  // of the palette
  std::vector<ChartPoint> points;
};

struct Panel {
  std::string x_label, y_label;
  std::vector<Series> series;
};

// Series of one label in several panels have one entry in the legend.
std::string svg_chart(const std::string& title, const std::vector<Panel>& panels);

}  // namespace lsos::validation
