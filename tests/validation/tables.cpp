#include "validation/tables.h"

#include <cmath>

#include "base/units.h"
#include "validation/report.h"

namespace lsos::validation {

namespace {

// A share as a percentage; "-" where nothing was measured.
std::string percent(double share) {
  return std::isnan(share) ? "-" : fmt::format("{:.1f}", 100 * share);
}

// Fixed-point text in which a rounded zero has no minus sign.
std::string fixed(double value, int decimals) {
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.find_first_of("123456789") == std::string::npos && text.starts_with('-')
             ? text.substr(1)
             : text;
}

}  // namespace

void summary_head(Text& t) {
  t.add(
      "| measurements | soil | points | pull, % of load | side force, % of load | torque, % of "
      "load x radius | sinkage, worst factor | sinkage, typical factor |");
  t.add("|---|---|---|---|---|---|---|---|");
}

void summary_row(Text& t, const Case& c, const std::string& what, const std::string& soil_name,
                 const Soil& soil, const std::vector<MeasuredPoint>& points) {
  const Errors e = errors_of(c, soil, points);
  t.add("| {} | {} | {} | {} | {} | {} | {:.2f} | {:.2f} |", what, soil_name, e.count,
        percent(e.pull), percent(e.side), percent(e.torque), e.sinkage_worst, e.sinkage_typical);
}

bool is_at_bound(const FitParameter& p, double value) {
  return value < p.low + p.step / 2 || value > p.high - p.step / 2;
}

void parameters(Text& t, const Case& c) {
  t.paragraph("{} parameters are fitted to {} measured values.", c.parameters.size(),
              2 * c.straight.size());
  t.add("\n| parameter | published | allowed | used |\n|---|---|---|---|");
  for (std::size_t i = 0; i < c.parameters.size(); ++i) {
    const FitParameter& p = c.parameters[i];
    const double value = c.fit.values[i];
    t.add("| {} | {} | {:.4g} to {:.4g} | {:.4g}, fitted{} |", p.name, p.published, p.low, p.high,
          value, is_at_bound(p, value) ? ", at its bound" : "");
  }
  for (const Constant& constant : c.constants) {
    t.add("| {} | {} | not fitted | {} |", constant.name, constant.value, constant.why);
  }
}

void straight_table(Text& t, const Case& c, const std::vector<MeasuredPoint>& points) {
  const std::vector<SingleWheelPoint> answers = compute(c.fit.soil, c.tests.wheel, points);
  const bool has_torque = !std::isnan(points.front().torque_n_m);
  t.add(
      "\n| slip | load, N | pull / load, measured | computed | error | sinkage, mm, measured | "
      "computed | factor |{}",
      has_torque ? " torque, N m, measured | computed |" : "");
  t.add("|---|---|---|---|---|---|---|---|{}", has_torque ? "---|---|" : "");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const MeasuredPoint& m = points[i];
    const SingleWheelPoint& a = answers[i];
    const double measured = m.drawbar_pull_n / m.load_n, computed = a.drawbar_pull_n / m.load_n;
    const std::string torques =
        has_torque ? fmt::format(" {:.2f} | {:.2f} |", m.torque_n_m, a.torque_n_m) : "";
    t.add("| {} | {:.1f} | {:.3f} | {:.3f} | {:+.3f} | {:.1f} | {:.1f} | {:.2f} |{}",
          fixed(m.slip, 2), m.load_n, measured, computed, computed - measured, 1000 * m.sinkage_m,
          1000 * a.sinkage_m, a.sinkage_m / m.sinkage_m, torques);
  }
}

void turned_table(Text& t, const Case& c, const std::vector<MeasuredPoint>& points) {
  const std::vector<SingleWheelPoint> answers = compute(c.fit.soil, c.tests.wheel, points);
  t.add(
      "\n| slip angle, deg | slip | load, N | pull / load, measured | computed | error | side "
      "force / "
      "load, measured | computed | error | sinkage, mm, measured | computed | factor |");
  t.add("|---|---|---|---|---|---|---|---|---|---|---|---|");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const MeasuredPoint& m = points[i];
    const SingleWheelPoint& a = answers[i];
    const double pull = m.drawbar_pull_n / m.load_n, side = m.side_force_n / m.load_n;
    const double pull_computed = a.drawbar_pull_n / m.load_n;
    const double side_computed = a.side_force_n / m.load_n;
    t.add(
        "| {:.0f} | {} | {:.1f} | {:.3f} | {:.3f} | {:+.3f} | {:.3f} | {} | {:+.3f} | {:.1f} | "
        "{:.1f} | {:.2f} |",
        degrees(m.slip_angle_rad), fixed(m.slip, 2), m.load_n, pull, pull_computed,
        pull_computed - pull, side, fixed(side_computed, 3), side_computed - side,
        1000 * m.sinkage_m, 1000 * a.sinkage_m, a.sinkage_m / m.sinkage_m);
  }
}

}  // namespace lsos::validation
