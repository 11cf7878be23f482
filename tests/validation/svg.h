// Charts as SVG text: panels side by side under one legend, with ticks at round numbers.
#pragma once

#include <string>
#include <vector>

namespace lsos::validation {

enum class Draw { line, dashed, markers };

struct ChartPoint {
  double x = 0, y = 0;
  double spread = 0;  // length of the error bar through the marker; 0: none
};

struct Series {
  std::string label;
  Draw draw = Draw::line;
  int colour = 0;  // index into the palette
  std::vector<ChartPoint> points;
};

struct Panel {
  std::string x_label, y_label;
  std::vector<Series> series;
};

// Series with the same label in several panels share one entry in the legend.
std::string svg_chart(const std::string& title, const std::vector<Panel>& panels);

}  // namespace lsos::validation
