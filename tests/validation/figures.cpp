#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "base/units.h"
#include "validation/report.h"
#include "validation/svg.h"

namespace lsos::validation {

namespace {

enum Colour { blue, orange, green, pink, grey };

// A quantity plotted in a panel, from measured and from computed points.
struct Quantity {
  std::string label;
  std::function<double(const MeasuredPoint&)> measured;
  std::function<double(const SingleWheelPoint&, double load_n)> computed;
  std::function<double(const MeasuredPoint&)> spread = [](const MeasuredPoint&) { return 0.0; };
};

const Quantity pull = {
    "drawbar pull / load", [](const MeasuredPoint& m) { return m.drawbar_pull_n / m.load_n; },
    [](const SingleWheelPoint& c, double load_n) { return c.drawbar_pull_n / load_n; },
    [](const MeasuredPoint& m) { return m.pull_spread_n / m.load_n; }};
const Quantity side = {
    "side force / load", [](const MeasuredPoint& m) { return m.side_force_n / m.load_n; },
    [](const SingleWheelPoint& c, double load_n) { return c.side_force_n / load_n; },
    [](const MeasuredPoint& m) { return m.side_spread_n / m.load_n; }};
const Quantity sinkage = {"sinkage, mm", [](const MeasuredPoint& m) { return 1000 * m.sinkage_m; },
                          [](const SingleWheelPoint& c, double) { return 1000 * c.sinkage_m; },
                          [](const MeasuredPoint& m) { return 1000 * m.sinkage_spread_m; }};
const Quantity torque = {"torque, N m", [](const MeasuredPoint& m) { return m.torque_n_m; },
                         [](const SingleWheelPoint& c, double) { return c.torque_n_m; }};

Series measured(const Quantity& q, const std::vector<MeasuredPoint>& points,
                const std::string& label, Colour colour) {
  Series series{label, Draw::markers, colour, {}};
  for (const MeasuredPoint& m : points) {
    series.points.push_back({m.slip, q.measured(m), q.spread(m)});
  }
  return series;
}

// A computed curve from the least to the greatest slip of the points.
struct CurvePoint {
  double load_n = 0;
  SingleWheelPoint answer;
};
using Curve = std::vector<CurvePoint>;

constexpr int curve_parts = 60;

// Between two points the load of the curve is interpolated linearly.
Curve curve(const Soil& soil, const Wheel& wheel, const std::vector<MeasuredPoint>& points) {
  Curve answer;
  const WheelSoil wheel_soil(soil, wheel, gravity_mps2);
  const double low = points.front().slip, high = points.back().slip;
  std::size_t next = 1;
  for (int i = 0; i <= curve_parts; ++i) {
    const double slip = low + (high - low) * i / curve_parts;
    while (next + 1 < points.size() && points[next].slip < slip) ++next;
    const MeasuredPoint &a = points[next - 1], &b = points[next];
    const double part = (slip - a.slip) / (b.slip - a.slip);
    const double load_n = a.load_n + part * (b.load_n - a.load_n);
    answer.push_back({load_n, single_wheel(wheel_soil, load_n, slip, a.slip_angle_rad)});
  }
  return answer;
}

Series computed(const Quantity& q, const Curve& curve, const std::string& label, Draw draw,
                Colour colour) {
  Series series{label, draw, colour, {}};
  for (const CurvePoint& p : curve) {
    series.points.push_back({p.answer.slip, q.computed(p.answer, p.load_n), 0});
  }
  return series;
}

constexpr const char* slip_label = "slip";

std::string straight_figure(const Case& c, const std::string& title,
                            const std::vector<Quantity>& quantities) {
  const Curve published = curve(c.published, c.tests.wheel, c.straight);
  const Curve fitted = curve(c.fit.soil, c.tests.wheel, c.straight);
  std::vector<Panel> panels;
  for (const Quantity& q : quantities) {
    panels.push_back({slip_label,
                      q.label,
                      {computed(q, published, "soil as published", Draw::dashed, grey),
                       computed(q, fitted, "fitted soil", Draw::line, blue),
                       measured(q, c.straight, "measured", orange)}});
  }
  return svg_chart(title, panels);
}

std::string slip_angle_figure(const Case& c, const std::string& title,
                              const std::vector<double>& angles_deg) {
  const std::vector<Quantity> quantities = {pull, side, sinkage};
  std::vector<Panel> panels;
  for (const Quantity& q : quantities) panels.push_back({slip_label, q.label, {}});
  int colour = blue;
  for (const double angle_deg : angles_deg) {
    const std::vector<MeasuredPoint> points = rolling_at(c.tests, angle_deg);
    const Curve fitted = curve(c.fit.soil, c.tests.wheel, points);
    const auto paint = static_cast<Colour>(colour++);
    for (std::size_t i = 0; i < panels.size(); ++i) {
      const std::string angle = fmt::format("{:.0f} deg, ", angle_deg);
      panels[i].series.push_back(
          computed(quantities[i], fitted, angle + "computed", Draw::line, paint));
      panels[i].series.push_back(measured(quantities[i], points, angle + "measured", paint));
    }
  }
  return svg_chart(title, panels);
}

// The locked wheel against the slip angle; computed at the measured angles and loads, joined by
// straight lines.
std::string locked_figure(const Case& c) {
  const std::vector<MeasuredPoint> points = locked(c.tests);
  const std::vector<SingleWheelPoint> answers = compute(c.fit.soil, c.tests.wheel, points);
  std::vector<Panel> panels;
  for (const Quantity& q : {pull, side, sinkage}) {
    Series line{"fitted soil", Draw::line, blue, {}}, marks{"measured", Draw::markers, orange, {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double angle_deg = degrees(points[i].slip_angle_rad);
      line.points.push_back({angle_deg, q.computed(answers[i], points[i].load_n), 0});
      marks.points.push_back({angle_deg, q.measured(points[i]), q.spread(points[i])});
    }
    panels.push_back({"slip angle, deg", q.label, {line, marks}});
  }
  return svg_chart("CMU, locked wheel (slip -1): beyond the model", panels);
}

std::string grouser_figure(const Cases& cases) {
  const auto line = [](const Case& c, const Wheel& wheel, const std::string& label, Colour colour) {
    std::vector<MeasuredPoint> ends(2);
    ends[0].slip = 0;
    ends[1].slip = 0.9;
    ends[0].load_n = ends[1].load_n = mean_load_n(c);
    return computed(pull, curve(c.fit.soil, wheel, ends), label, Draw::line, colour);
  };
  const auto label = [](const GrouserSet& g) {
    return fmt::format("{} grousers of {:.0f} mm", g.count, 1000 * g.height_m);
  };
  Panel cmu{"slip, CMU wheel", pull.label, {}}, ding{"slip, Ding's wheel", pull.label, {}};
  cmu.series.push_back(line(cases.cmu, cases.cmu.tests.wheel, "smooth", grey));
  const Wheel& rim = cases.cmu.tests.wheel;
  cmu.series.push_back(
      line(cases.cmu, with_grousers(rim, cmu_grousers), label(cmu_grousers), blue));
  ding.series.push_back(line(cases.ding, cases.ding.tests.wheel, "smooth", grey));
  int colour = orange;
  for (const GrouserSet& g : ding_grousers) {
    ding.series.push_back(line(cases.ding, with_grousers(cases.ding.tests.wheel, g), label(g),
                               static_cast<Colour>(colour++)));
  }
  return svg_chart("Predicted, not measured: grousers", {cmu, ding});
}

}  // namespace

Files figures(const Cases& cases) {
  const std::string folder = "core/vehicle/validation/";
  Files files;
  files[folder + "cmu_straight.svg"] =
      straight_figure(cases.cmu, "CMU, rolling straight", {pull, sinkage});
  files[folder + "cmu_slip_angles.svg"] =
      slip_angle_figure(cases.cmu, "CMU, slip angles to 45 deg: not refitted", {15, 30, 45});
  files[folder + "cmu_beyond.svg"] =
      slip_angle_figure(cases.cmu, "CMU, slip angles above 45 deg: beyond the model", {60, 75, 90});
  files[folder + "cmu_locked.svg"] = locked_figure(cases.cmu);
  files[folder + "ding.svg"] =
      straight_figure(cases.ding, "Ding et al. 2011, smooth wheel", {pull, sinkage, torque});
  files[folder + "kls1.svg"] = straight_figure(
      cases.kls, "Wang and Han 2016, smooth wheel on KLS-1", {pull, sinkage, torque});
  files[folder + "grousers.svg"] = grouser_figure(cases);
  return files;
}

}  // namespace lsos::validation
