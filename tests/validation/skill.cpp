#include "validation/skill.h"

#include <fmt/ranges.h>

#include <algorithm>
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

// Adds a set's rows. Returns the parts of the set in which an answer without a model errs less than
// the model with the fitted soil: "", or "NAME (all, driven)".
std::string rows(Text& t, const std::string& name, const Case& c, const Wheel& wheel,
                 const std::vector<MeasuredPoint>& points, bool is_straight) {
  const auto row = [&](const char* method, const std::vector<double>& pulls) {
    const PullErrors e = pull_errors(points, pulls);
    t.add("| {} | {} | {} | {} | {} | {} | {} |", name, points.size(), method, percent(e.all),
          percent(e.driving), percent(e.braking), percent(e.small_slip));
    return e;
  };
  const PullErrors model = row("model, fitted soil", computed(c.fit.soil, wheel, points));
  row("model, published soil", computed(c.published, wheel, points));
  if (is_straight) row("rim integrals, published soil", by_integrals(c.published, wheel, points));
  const PullErrors constant = row("best constant", best_constant(points));
  const PullErrors zero = row("always zero", std::vector<double>(points.size(), 0));
  std::vector<std::string> parts;
  const auto compare = [&](const char* part, double PullErrors::*error) {
    if (model.*error > std::min(constant.*error, zero.*error)) parts.push_back(part);
  };
  compare("all", &PullErrors::all);
  compare("driven", &PullErrors::driving);
  compare("braked", &PullErrors::braking);
  compare("small slip", &PullErrors::small_slip);
  return parts.empty() ? "" : fmt::format("{} ({})", name, fmt::join(parts, ", "));
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
  std::vector<std::string> without_skill;
  const auto add = [&](const std::string& name, const Case& c, const Wheel& wheel,
                       const std::vector<MeasuredPoint>& points, bool is_straight) {
    const std::string parts = rows(t, name, c, wheel, points, is_straight);
    if (!parts.empty()) without_skill.push_back(parts);
  };
  add("CMU, smooth, straight", cases.cmu, cases.cmu.tests.wheel, cases.cmu.straight, true);
  add("CMU, smooth, 0 to 45 deg", cases.cmu, cases.cmu.tests.wheel,
      rolling_at(cases.cmu.tests, {0, 15, 30, 45}), false);
  const WheelTests& cmu = cases.cmu.grousered;
  add("CMU, 24 grousers of 4.9 mm, straight", cases.cmu, cmu.wheel, rolling_at(cmu, 0), true);
  add("CMU, grousers, 0 to 45 deg", cases.cmu, cmu.wheel, rolling_at(cmu, {0, 15, 30, 45}), false);
  add("CMU, grousers, 0 to 90 deg", cases.cmu, cmu.wheel,
      rolling_at(cmu, {0, 15, 30, 45, 60, 75, 90}), false);
  add("Ding, smooth", cases.ding, cases.ding.tests.wheel, cases.ding.straight, true);
  add("Ding, 30 lugs of 10 mm", cases.ding, cases.ding.grousered.wheel,
      rolling_at(cases.ding.grousered, 0), true);
  add("KLS-1, smooth", cases.kls, cases.kls.tests.wheel, cases.kls.straight, true);
  const std::string sets = fmt::format("{}", fmt::join(without_skill, "; "));
  t.paragraph(
      "Where one of the two constants is nearer, the model with the fitted soil shows no "
      "skill: {}.",
      sets.empty() ? "nowhere" : sets);
}

}  // namespace lsos::validation
