#include "product/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "product/event_kinds.h"
#include "product/figure_pen.h"

namespace lsos {

namespace {

constexpr double width_mm = 180, left_mm = 18, right_margin_mm = 4, top_least_mm = 9;
constexpr double map_least_mm = 42, map_most_mm = 85, panel_mm = 34;
constexpr double bar_mm = 2.4, bar_apart_mm = 0.5, bars_below_mm = 1.2;
constexpr double below_axis_mm = 10.5, between_mm = 3, legend_row_mm = 4.2;
constexpr double rover_sample_mm = 8.5, kind_sample_mm = 6.2;
constexpr double letters_mm = 2.6, small_mm = 2.3;

const Stroke axis{"#000000", 0.22, {}}, grid{"#dddddd", 0.14, {}}, failed{"#c62828", 0.25, {}},
    incomplete{"#555555", 0.2, {}};

// The least of 1, 2, 5 times a power of ten that is not below `least`.
double round_step(double least) {
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * decade >= least * (1 - 1e-9)) return digit * decade;
  }
  return 10 * decade;
}

struct Range {
  double least = 1e300, greatest = -1e300;
  void add(double value) {
    if (std::isnan(value)) return;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  double span() const { return greatest - least; }
  // Widened on both sides by that share of the span; never empty.
  Range padded(double share) const {
    if (greatest < least) return {0, 1};
    const double pad = span() > 0 ? share * span() : std::max(1e-3, 0.05 * std::abs(greatest));
    return {least - pad, greatest + pad};
  }
};

std::string tick_text(double value, double step) {
  const int places = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  std::string text = fmt::format("{:.{}f}", std::abs(value) < step / 2 ? 0.0 : value, places);
  if (text.starts_with('-')) text.replace(0, 1, "\u2212");
  return text;
}

std::vector<double> ticks(const Range& range, double step) {
  std::vector<double> values;
  for (double k = std::ceil(range.least / step - 1e-9); k * step <= range.greatest + 1e-9 * step;
       ++k) {
    values.push_back(k * step);
  }
  return values;
}

struct TimeUnit {
  const char* symbol;
  double per_s;
};
TimeUnit time_unit(double end_s) {
  if (end_s <= 180) return {"s", 1};
  if (end_s <= 3 * 3600) return {"min", 1 / 60.0};
  if (end_s <= 3 * 86400) return {"h", 1 / 3600.0};
  return {"d", 1 / 86400.0};
}

class Axes {
 public:
  Axes(FigurePen& pen, const PaperBox& box, const Range& x, const Range& y)
      : pen_(pen), box_(box), x_(x), y_(y) {}
  PaperPoint at(double x, double y) const {
    return {box_.left_mm + (x - x_.least) / x_.span() * box_.width_mm,
            box_.bottom_mm() - (y - y_.least) / y_.span() * box_.height_mm};
  }
  // `axis_mm`: y of the horizontal axis' ticks and numbers.
  void draw(const std::string& x_name, const std::string& y_name, double axis_mm) {
    const double x_step = round_step(x_.span() * 18 / box_.width_mm);
    const double y_step = round_step(y_.span() * 7 / box_.height_mm);
    for (const double x : ticks(x_, x_step)) {
      const double x_mm = at(x, 0).x_mm;
      pen_.line({{x_mm, box_.top_mm}, {x_mm, box_.bottom_mm()}}, grid);
      pen_.line({{x_mm, axis_mm}, {x_mm, axis_mm + 1}}, axis);
      pen_.write(tick_text(x, x_step), {x_mm, axis_mm + 3.7}, small_mm, Anchor::middle);
    }
    for (const double y : ticks(y_, y_step)) {
      const double y_mm = at(0, y).y_mm;
      pen_.line({{box_.left_mm, y_mm}, {box_.right_mm(), y_mm}}, grid);
      pen_.line({{box_.left_mm - 1, y_mm}, {box_.left_mm, y_mm}}, axis);
      pen_.write(tick_text(y, y_step), {box_.left_mm - 1.6, y_mm + 0.8}, small_mm, Anchor::right);
    }
    pen_.write(x_name, {box_.left_mm + box_.width_mm / 2, axis_mm + 7.4}, letters_mm,
               Anchor::middle);
    pen_.write(y_name, {box_.left_mm - 12.6, box_.top_mm + box_.height_mm / 2}, letters_mm,
               Anchor::middle, false, true);
  }
  void line(const std::vector<double>& x, const std::vector<double>& y, const Stroke& stroke) {
    pen_.clip(box_);
    std::vector<PaperPoint> points;
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (std::isnan(x[k]) || std::isnan(y[k])) {
        pen_.line(points, stroke);
        points.clear();
      } else {
        points.push_back(at(x[k], y[k]));
      }
    }
    pen_.line(points, stroke);
    pen_.clip({});
  }
  void frame() { pen_.frame(box_, axis); }

 private:
  FigurePen& pen_;
  PaperBox box_;
  Range x_, y_;
};

Stroke stroke_of(const ReportRover& rover, double thick_mm = 0.35) {
  return {rover.colour, thick_mm, {}};
}

std::vector<double> scaled(const std::vector<double>& values, double factor, double from = 0) {
  std::vector<double> changed;
  for (const double value : values) changed.push_back((value - from) * factor);
  return changed;
}

class Figure {
 public:
  Figure(const ReportData& data, int dpi)
      : data_(data),
        unit_(time_unit(data.end_s)),
        kinds_(event_kinds(data.events, data.activities)),
        ruler_(std::make_unique<FigurePen>(1, 1, dpi)),
        top_mm_(top_least_mm + (data.rovers.empty() ? 0 : rover_legend_places().back().y_mm)),
        map_mm_(map_height_mm()),
        pen_(width_mm, height_mm(), dpi) {}

  std::string draw() {
    draw_rover_legend();
    plan_view();
    double top = top_mm_ + map_mm_ + below_axis_mm + between_mm;
    for (const Panel& panel : panels()) {
      time_panel(panel, top);
      top += panel_mm + bars_mm() + below_axis_mm + between_mm;
    }
    draw_kind_legend(top);
    return pen_.png();
  }

 private:
  struct Panel {
    std::string letter, name;
    const char* column;
    double factor = 1;
    bool is_relative = false;
  };

  double box_width_mm() const { return width_mm - left_mm - right_margin_mm; }
  double bars_mm() const {
    return bars_below_mm + static_cast<double>(data_.rovers.size()) * (bar_mm + bar_apart_mm);
  }
  double height_mm() const {
    return top_mm_ + map_mm_ + below_axis_mm + between_mm +
           3 * (panel_mm + bars_mm() + below_axis_mm + between_mm) + kind_legend_mm();
  }
  Range extent(std::size_t column) const {
    Range range;
    for (const ReportRover& rover : data_.rovers) {
      for (const double value : rover.position.column(column)) range.add(value);
    }
    return range.padded(0.06);
  }
  double map_height_mm() const {
    const Range x = extent(position_x), y = extent(position_y);
    return std::clamp(box_width_mm() * y.span() / x.span(), map_least_mm, map_most_mm);
  }
  const ThinnedRows* series(const ReportRover& rover, const std::string& name) const {
    for (const auto& [column, rows] : rover.series) {
      if (column == name) return &rows;
    }
    return nullptr;
  }
  double greatest(const std::string& name) const {
    double most = 0;
    for (const ReportRover& rover : data_.rovers) {
      for (const double value : series(rover, name)->column(0)) {
        if (!std::isnan(value)) most = std::max(most, std::abs(value));
      }
    }
    return most;
  }
  std::array<Panel, 3> panels() const {
    const bool is_kwh = greatest("energy_j") >= 3.6e6, is_kw = greatest("energy_rate_w") >= 2000;
    return {{{"(b)", "relative elevation (m)", "elevation_m", 1, true},
             {"(c)", is_kwh ? "energy (kWh)" : "energy (Wh)", "energy_j",
              is_kwh ? 1 / 3.6e6 : 1 / 3600.0, false},
             {"(d)", is_kw ? "energy rate (kW)" : "energy rate (W)", "energy_rate_w",
              is_kw ? 1e-3 : 1, false}}};
  }

  // Places of the rovers' keys, above all panels.
  std::vector<PaperPoint> rover_legend_places() const {
    std::vector<std::string> names;
    for (const ReportRover& rover : data_.rovers) names.push_back(rover.id);
    return legend_places(names, letters_mm, rover_sample_mm);
  }
  void draw_rover_legend() {
    const std::vector<PaperPoint> places = rover_legend_places();
    for (std::size_t k = 0; k < places.size(); ++k) {
      const ReportRover& rover = data_.rovers[k];
      const double x_mm = places[k].x_mm, y_mm = 4 + places[k].y_mm;
      pen_.line({{x_mm, y_mm}, {x_mm + 7, y_mm}}, stroke_of(rover, 0.6));
      pen_.write(rover.id, {x_mm + rover_sample_mm, y_mm + 0.9}, letters_mm, Anchor::left);
    }
  }
  // Places of keys with a sample before each name, in rows from y = 0 downwards.
  std::vector<PaperPoint> legend_places(const std::vector<std::string>& names, double size_mm,
                                        double sample_mm) const {
    constexpr double apart_mm = 6;
    std::vector<PaperPoint> places;
    PaperPoint at{left_mm, 0};
    for (const std::string& name : names) {
      const double long_mm = sample_mm + ruler_->text_width_mm(name, size_mm);
      if (at.x_mm > left_mm && at.x_mm + long_mm > width_mm - right_margin_mm) {
        at = {left_mm, at.y_mm + legend_row_mm};
      }
      places.push_back(at);
      at.x_mm += long_mm + apart_mm;
    }
    return places;
  }

  // A map with equal scales to the north and to the east.
  void plan_view() {
    Range x = extent(position_x), y = extent(position_y);
    const PaperBox box{left_mm, top_mm_, box_width_mm(), map_mm_};
    const double m_per_mm = std::max(x.span() / box.width_mm, y.span() / box.height_mm);
    const auto widen = [&](Range& range, double length_mm) {
      const double more = (m_per_mm * length_mm - range.span()) / 2;
      range = {range.least - more, range.greatest + more};
    };
    widen(x, box.width_mm);
    widen(y, box.height_mm);
    Axes axes(pen_, box, x, y);
    axes.draw("east (m)", "north (m)", box.bottom_mm());
    for (const ReportRover& rover : data_.rovers) {
      axes.line(rover.position.column(position_x), rover.position.column(position_y),
                stroke_of(rover, 0.4));
    }
    // Mark each start; it is all that shows of a rover that never moves.
    constexpr double dot_mm = 1.6;
    for (const ReportRover& rover : data_.rovers) {
      if (rover.position.times_s().empty()) continue;
      const PaperPoint at = axes.at(rover.position.column(position_x).front(),
                                    rover.position.column(position_y).front());
      pen_.fill({at.x_mm - dot_mm / 2, at.y_mm - dot_mm / 2, dot_mm, dot_mm}, rover.colour);
    }
    axes.frame();
    letter("(a)", box);
  }

  void letter(const std::string& text, const PaperBox& box) {
    pen_.write(text, {box.left_mm - 10.4, box.top_mm + 1}, letters_mm, Anchor::right, true);
  }

  void time_panel(const Panel& panel, double top) {
    const PaperBox box{left_mm, top, box_width_mm(), panel_mm};
    Range y;
    std::vector<std::vector<double>> lines;
    for (const ReportRover& rover : data_.rovers) {
      const std::vector<double>& values = series(rover, panel.column)->column(0);
      double from = 0;
      if (panel.is_relative) {
        const auto first = std::ranges::find_if(values, [](double v) { return !std::isnan(v); });
        if (first != values.end()) from = *first;
      }
      lines.push_back(scaled(values, panel.factor, from));
      for (const double value : lines.back()) y.add(value);
    }
    const Range x{0, std::max(data_.end_s, 1.0) * unit_.per_s};
    Axes axes(pen_, box, x, y.padded(0.08));
    axes.draw(fmt::format("time ({})", unit_.symbol), panel.name, box.bottom_mm() + bars_mm());
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const ReportRover& rover = data_.rovers[k];
      axes.line(scaled(series(rover, panel.column)->times_s(), unit_.per_s), lines[k],
                stroke_of(rover));
    }
    axes.frame();
    letter(panel.letter, box);
    bars(box);
  }

  void bars(const PaperBox& box) {
    const auto x_mm = [&](SimTime time) {
      return box.left_mm + seconds(time) / std::max(data_.end_s, 1.0) * box.width_mm;
    };
    double top = box.bottom_mm() + bars_below_mm;
    for (const ReportRover& rover : data_.rovers) {
      pen_.fill({box.left_mm - 2, top, 1.2, bar_mm}, rover.colour);
      pen_.fill({box.left_mm, top, box.width_mm, bar_mm}, "#f2f2f2");
      for (const EventRow& event : data_.events) {
        if (event.rover_id != rover.id || !event.start) continue;
        const double from = x_mm(*event.start);
        const double to = x_mm(event.end.value_or(from_seconds(data_.end_s)));
        const PaperBox bar{from, top, std::max(0.15, to - from - 0.15), bar_mm};
        pen_.fill(bar, kind_of(kinds_, event.type).colour);
        if (event.status == EventStatus::failed) pen_.hatch(bar, failed, 1);
        if (event.status == EventStatus::incomplete) pen_.hatch(bar, incomplete, 1);
      }
      top += bar_mm + bar_apart_mm;
    }
  }

  // Kinds of which an event has started.
  std::vector<const EventKind*> used_kinds() const {
    std::vector<const EventKind*> used;
    for (const EventKind& kind : kinds_) {
      const bool is_used = std::ranges::any_of(data_.events, [&](const EventRow& event) {
        return event.start && &kind_of(kinds_, event.type) == &kind;
      });
      if (is_used) used.push_back(&kind);
    }
    return used;
  }
  std::vector<PaperPoint> kind_legend_places() const {
    std::vector<std::string> names;
    for (const EventKind* kind : used_kinds()) names.push_back(kind->name);
    return legend_places(names, small_mm, kind_sample_mm);
  }
  double kind_legend_mm() const {
    const std::vector<PaperPoint> places = kind_legend_places();
    return legend_row_mm + (places.empty() ? 0 : places.back().y_mm);
  }
  void draw_kind_legend(double top) {
    const std::vector<const EventKind*> used = used_kinds();
    const std::vector<PaperPoint> places = kind_legend_places();
    for (std::size_t k = 0; k < used.size(); ++k) {
      const double x_mm = places[k].x_mm, y_mm = top + places[k].y_mm;
      pen_.fill({x_mm, y_mm, 5, bar_mm}, used[k]->colour);
      pen_.write(used[k]->name, {x_mm + kind_sample_mm, y_mm + 2.1}, small_mm, Anchor::left);
    }
  }

  const ReportData& data_;
  TimeUnit unit_;
  std::vector<EventKind> kinds_;
  std::unique_ptr<FigurePen> ruler_;  // measures text before the size of the sheet is known
  double top_mm_;
  double map_mm_;
  FigurePen pen_;
};

}  // namespace

std::string figure_png(const ReportData& data, int dpi) { return Figure(data, dpi).draw(); }

}  // namespace lsos
