#include "validation/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

namespace lsos::validation {

namespace {

// Okabe and Ito's colours, which most colour-blind readers can tell apart, and a grey.
constexpr std::array<std::string_view, 5> palette = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                     "#777777"};
constexpr int grey = 4;
static_assert(grey == palette.size() - 1);

// All lengths are in pixels.
constexpr double plot_width = 250, plot_height = 220;
constexpr double left = 58, right = 14, below = 46, title_height = 26, legend_row = 20;
constexpr double legend_mark = 30, letter = 6.6, legend_gap = 20;

struct Axis {
  double low = 0, high = 1, tick = 1;
  int decimals = 0;
};

// Round limits and ticks around the values, with a margin.
Axis axis_over(double low, double high) {
  if (high <= low) high = low + 1;
  // The margin keeps markers off the frame.
  const double margin = 0.03 * (high - low);
  low -= margin;
  high += margin;
  const double rough = (high - low) / 5;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  Axis axis;
  for (const double round : {1.0, 2.0, 5.0, 10.0}) {
    axis.tick = round * power;
    if (axis.tick >= rough) break;
  }
  const double part = axis.tick / 4;
  axis.low = std::floor(low / part) * part;
  axis.high = std::ceil(high / part) * part;
  axis.decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(axis.tick) - 1e-9)));
  return axis;
}

class Drawing {
 public:
  std::string text;

  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
    text += '\n';
  }

  void line(double x1, double y1, double x2, double y2, std::string_view colour, double width = 1) {
    add(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" stroke="{}" stroke-width="{}"/>)",
        x1, y1, x2, y2, colour, width);
  }
  void circle(double x, double y, std::string_view colour) {
    add(R"(<circle cx="{:.1f}" cy="{:.1f}" r="3.5" fill="#ffffff" stroke="{}" stroke-width="1.8"/>)",
        x, y, colour);
  }
  void words(double x, double y, std::string_view anchor, std::string_view what) {
    add(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor, what);
  }
};

std::string_view dashes(Draw draw) {
  return draw == Draw::dashed ? R"( stroke-dasharray="5 4")" : "";
}

void draw_panel(Drawing& d, const Panel& panel, double x0, double y0) {
  double x_low = 1e300, x_high = -1e300, y_low = 0, y_high = 0;  // y = 0 is always visible
  for (const Series& s : panel.series) {
    for (const ChartPoint& p : s.points) {
      x_low = std::min(x_low, p.x);
      x_high = std::max(x_high, p.x);
      y_low = std::min(y_low, p.y - p.spread / 2);
      y_high = std::max(y_high, p.y + p.spread / 2);
    }
  }
  const Axis ax = axis_over(x_low, x_high), ay = axis_over(y_low, y_high);
  const auto at_x = [&](double x) { return x0 + (x - ax.low) / (ax.high - ax.low) * plot_width; };
  const auto at_y = [&](double y) {
    return y0 + plot_height - (y - ay.low) / (ay.high - ay.low) * plot_height;
  };

  const auto ticks = [](const Axis& axis, const auto& draw) {
    const int first = static_cast<int>(std::ceil(axis.low / axis.tick - 1e-6));
    for (int i = first; i * axis.tick <= axis.high + 1e-6 * axis.tick; ++i) {
      draw(i * axis.tick, fmt::format("{:.{}f}", i == 0 ? 0 : i * axis.tick, axis.decimals));
    }
  };
  ticks(ax, [&](double x, const std::string& label) {
    d.line(at_x(x), y0, at_x(x), y0 + plot_height, "#e4e4e4");
    d.words(at_x(x), y0 + plot_height + 16, "middle", label);
  });
  ticks(ay, [&](double y, const std::string& label) {
    d.line(x0, at_y(y), x0 + plot_width, at_y(y), y == 0 ? "#999999" : "#e4e4e4");
    d.words(x0 - 6, at_y(y) + 4, "end", label);
  });
  d.add(R"(<rect x="{:.1f}" y="{:.1f}" width="{}" height="{}" fill="none" stroke="#333333"/>)", x0,
        y0, plot_width, plot_height);
  d.words(x0 + plot_width / 2, y0 + plot_height + 36, "middle", panel.x_label);
  d.add(
      R"svg(<text transform="translate({:.1f} {:.1f}) rotate(-90)" text-anchor="middle">{}</text>)svg",
      x0 - left + 14, y0 + plot_height / 2, panel.y_label);

  for (const Series& s : panel.series) {
    const std::string_view colour = palette[s.colour];
    if (s.draw == Draw::markers) {
      for (const ChartPoint& p : s.points) {
        if (p.spread > 0) {
          d.line(at_x(p.x), at_y(p.y - p.spread / 2), at_x(p.x), at_y(p.y + p.spread / 2), colour,
                 1.5);
        }
        d.circle(at_x(p.x), at_y(p.y), colour);
      }
      continue;
    }
    std::string points;
    for (const ChartPoint& p : s.points) {
      points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", at_x(p.x), at_y(p.y));
    }
    d.add(R"(<polyline points="{}" fill="none" stroke="{}" stroke-width="1.8"{}/>)", points, colour,
          dashes(s.draw));
  }
}

std::vector<Series> legend_of(const std::vector<Panel>& panels) {
  std::vector<Series> legend;
  for (const Panel& panel : panels) {
    for (const Series& s : panel.series) {
      if (std::ranges::find(legend, s.label, &Series::label) == legend.end()) legend.push_back(s);
    }
  }
  return legend;
}

}  // namespace

std::string svg_chart(const std::string& title, const std::vector<Panel>& panels) {
  const std::vector<Series> legend = legend_of(panels);
  const double panel_width = left + plot_width + right;
  const double width = panel_width * static_cast<double>(panels.size());
  std::size_t letters = 0;
  for (const Series& s : legend) letters = std::max(letters, s.label.size());
  const double legend_entry = legend_mark + letter * static_cast<double>(letters) + legend_gap;
  const int columns = std::max(1, static_cast<int>((width - 20) / legend_entry));
  const int rows = (static_cast<int>(legend.size()) + columns - 1) / columns;
  const double top = title_height + rows * legend_row + 10;
  const double height = top + plot_height + below;

  Drawing d;
  d.add(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}")"
        R"( font-family="sans-serif" font-size="12" fill="#222222">)",
        width, height);
  d.add(R"(<rect width="{}" height="{}" fill="#ffffff"/>)", width, height);
  d.add(R"(<text x="20" y="18" font-size="14" font-weight="bold">{}</text>)", title);
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const double x = 20 + legend_entry * static_cast<double>(i % columns);
    const double y = title_height + 12 + legend_row * static_cast<double>(i / columns);
    const std::string_view colour = palette[legend[i].colour];
    if (legend[i].draw == Draw::markers) {
      d.circle(x + 12, y - 4, colour);
    } else {
      d.add(R"(<polyline points="{:.1f},{:.1f} {:.1f},{:.1f}" stroke="{}" stroke-width="1.8"{}/>)",
            x, y - 4, x + 24, y - 4, colour, dashes(legend[i].draw));
    }
    d.words(x + legend_mark, y, "start", legend[i].label);
  }
  for (std::size_t i = 0; i < panels.size(); ++i) {
    draw_panel(d, panels[i], left + panel_width * static_cast<double>(i), top);
  }
  d.text += "</svg>\n";
  return d.text;
}

}  // namespace lsos::validation
