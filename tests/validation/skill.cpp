#include "validation/skill.h"

#include <cmath>

#include "validation/rim_integrals.h"

namespace lsos::validation {

namespace {

// A slip at which rovers drive: -0.02 to 0.25.
bool is_small(double slip) { return slip > -0.02 && slip <= 0.25; }

std::string percent(double share) {
  return std::isnan(share) ? "-" : fmt::format("{:.1f}", 100 * share);
}

std::vector<double> computed(const Soil& soil, const Wheel& wheel,
                             const std::vector<MeasuredPoint>& points) {
  const std::vector<SingleWheelPoint> answers = compute(soil, wheel, points);
  std::vector<double> pulls;
  for (std::size_t i = 0; i < points.size(); ++i) {
    pulls.push_back(answers[i].drawbar_pull_n / points[i].load_n);
  }
  return pulls;
}

std::vector<double> by_integrals(const Soil& soil, const Wheel& wheel,
                                 const std::vector<MeasuredPoint>& points) {
  const double shear_radius_m = WheelSoil(soil, wheel, gravity_mps2).shear_radius_m();
  std::vector<double> pulls;
  for (const MeasuredPoint& p : points) {
    const double slip = slip_by(shear_radius_m, p.slip, p.slip_radius_m);
    pulls.push_back(rim_integrals(soil, wheel, p.load_n, slip).drawbar_pull_n / p.load_n);
  }
  return pulls;
}

std::vector<double> best_constant(const std::vector<MeasuredPoint>& points) {
  double mean = 0;
  for (const MeasuredPoint& p : points) {
    mean += p.drawbar_pull_n / p.load_n / static_cast<double>(points.size());
  }
  return std::vector<double>(points.size(), mean);
}

void rows(Text& t, const std::string& name, const Case& c, const Wheel& wheel,
          const std::vector<MeasuredPoint>& points, bool is_straight) {
  const auto row = [&](const char* method, const std::vector<double>& pulls) {
    const PullErrors e = pull_errors(points, pulls);
    t.add("| {} | {} | {} | {} | {} | {} | {} |", name, points.size(), method, percent(e.all),
          percent(e.driving), percent(e.braking), percent(e.small_slip));
  };
  row("model, fitted soil", computed(c.fit.soil, wheel, points));
  row("model, published soil", computed(c.published, wheel, points));
  if (is_straight) row("rim integrals, published soil", by_integrals(c.published, wheel, points));
  row("best constant", best_constant(points));
  row("always zero", std::vector<double>(points.size(), 0));
}

}  // namespace

PullErrors pull_errors(const std::vector<MeasuredPoint>& points, const std::vector<double>& pulls) {
  const auto rms = [&](const auto& is_of_part) {
    double squares = 0;
    int count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!is_of_part(points[i].slip)) continue;
      const double error = pulls[i] - points[i].drawbar_pull_n / points[i].load_n;
      squares += error * error;
      ++count;
    }
    return std::sqrt(squares / count);
  };
  return {rms([](double) { return true; }), rms([](double slip) { return slip > 0.02; }),
          rms([](double slip) { return slip < -0.02; }), rms(is_small)};
}

void skill(Text& t, const Cases& cases) {
  t.add("\n## Skill against simpler answers");
  t.paragraph(
      "RMS errors of the pull in % of the load: over all points of a set, over driven wheels (slip "
      "above 0.02), braked ones (below -0.02), and at the slips at which rovers drive (-0.02 to "
      "0.25). Rim integrals are those of Wong and Reece (1967) with Bekker's pressure, "
      "`tests/validation/rim_integrals.h`; the best constant knows the mean of the very points "
      "that "
      "it is judged by. Nothing was fitted to a wheel with grousers.");
  t.add(
      "\n| measurements | points | answer | all | driven | braked | small slip |\n"
      "|---|---|---|---|---|---|---|");
  rows(t, "CMU, smooth, straight", cases.cmu, cases.cmu.tests.wheel, cases.cmu.straight, true);
  rows(t, "CMU, smooth, 0 to 45 deg", cases.cmu, cases.cmu.tests.wheel,
       rolling_at(cases.cmu.tests, {0, 15, 30, 45}), false);
  const WheelTests& cmu = cases.cmu.grousered;
  rows(t, "CMU, 24 grousers of 4.9 mm, straight", cases.cmu, cmu.wheel, rolling_at(cmu, 0), true);
  rows(t, "CMU, grousers, 0 to 45 deg", cases.cmu, cmu.wheel, rolling_at(cmu, {0, 15, 30, 45}),
       false);
  rows(t, "CMU, grousers, 0 to 90 deg", cases.cmu, cmu.wheel,
       rolling_at(cmu, {0, 15, 30, 45, 60, 75, 90}), false);
  rows(t, "Ding, smooth", cases.ding, cases.ding.tests.wheel, cases.ding.straight, true);
  rows(t, "Ding, 30 lugs of 10 mm", cases.ding, cases.ding.grousered.wheel,
       rolling_at(cases.ding.grousered, 0), true);
  rows(t, "KLS-1, smooth", cases.kls, cases.kls.tests.wheel, cases.kls.straight, true);
}

}  // namespace lsos::validation
