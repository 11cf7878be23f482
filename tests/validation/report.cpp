#include "validation/report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "validation/skill.h"
#include "validation/tables.h"

namespace lsos::validation {

namespace {

void introduction(Text& t) {
  t.add(
      "This file and `validation/` are written by the program `write_validation` (`cmake --preset "
      "dev && cmake --build build/dev --target write_validation && "
      "build/dev/bin/write_validation`);"
      " do not edit them.\n");
  t.add("# The wheel on soil against measurements");
  t.paragraph(
      "What `single_wheel.h` computes for the settings at which single wheels were measured in "
      "soil bins: slip, slip angle and the mean load of each point, on Earth. Each soil has one "
      "set of parameters for all of its points. Slip is 1 - v/(r w) when driving and r w/v - 1 "
      "when braking, v the speed of travel and r the radius by which the rig counts; the model's "
      "own slip is by the rolling radius of `wheel_soil.h`, and is converted. Pull is along the "
      "heading, side force to the left with travel to the left of the heading.");
  t.paragraph(
      "A fit makes the mean square error of pull / load, in units of {}, and that of the "
      "logarithm of sinkage, in units of ln {}, least together: the two aims weigh alike. It "
      "searches a grid inside the bounds that each section states. Torque and side force are "
      "never fitted, nor is any point at a slip angle or of the locked wheel. The measurements "
      "are reference data (`terramech/` of `LSOS_REFERENCE_DATA`) and no part of this tree.",
      pull_aim, sinkage_aim);
}

int values_at_bounds(const Case& c) {
  int count = 0;
  for (std::size_t i = 0; i < c.parameters.size(); ++i) {
    if (is_at_bound(c.parameters[i], c.fit.values[i])) ++count;
  }
  return count;
}

void summary(Text& t, const Cases& cases) {
  t.add("\n## Summary");
  t.paragraph(
      "Errors are root mean squares over the points. The typical factor of sinkage is that of "
      "the root mean square logarithm. \"Published\" is the soil as published with "
      "slip sinkage {}, the program's default, nothing fitted.",
      Soil{}.slip_sinkage);
  summary_head(t);
  for (const Case* c : {&cases.cmu, &cases.ding, &cases.kls}) {
    summary_row(t, *c, c->name + ", straight", "published", c->published, c->straight);
    summary_row(t, *c, c->name + ", straight", "**fitted** here", c->fit.soil, c->straight);
    if (c != &cases.cmu) continue;
    const auto not_refitted = [&](const std::string& what,
                                  const std::vector<MeasuredPoint>& points) {
      summary_row(t, *c, c->name + ", " + what, "the same, not refitted", c->fit.soil, points);
    };
    for (const double angle_deg : {15, 30, 45}) {
      not_refitted(fmt::format("slip angle {} deg", angle_deg), rolling_at(c->tests, angle_deg));
    }
    not_refitted("15 to 45 deg together", rolling_at(c->tests, {15, 30, 45}));
    for (const double angle_deg : {60, 75, 90}) {
      not_refitted(fmt::format("{} deg, beyond the model", angle_deg),
                   rolling_at(c->tests, angle_deg));
    }
    not_refitted("locked, 0 to 90 deg, beyond the model", locked(c->tests));
  }
  t.add("\n| aim | wanted | found | reached |\n|---|---|---|---|");
  for (const Aim& aim : aims(cases)) {
    t.add("| {} | {} | {} | {} |", aim.what, aim.aim, aim.found, aim.is_reached ? "yes" : "**no**");
  }
  int at_bounds = 0, fitted = 0;
  for (const Case* c : {&cases.cmu, &cases.ding, &cases.kls}) {
    at_bounds += values_at_bounds(*c);
    fitted += static_cast<int>(c->parameters.size());
  }
  t.paragraph("Of {} fitted values {} end at a bound: without it they would go on.", fitted,
              at_bounds);
}

void cmu(Text& t, const Case& c) {
  t.add("\n## CMU: small smooth wheel in sand, straight and at slip angles");
  int trials = 0;
  double pull_spread = 0, sinkage_spread_m = 0, offset_low = 1, offset_high = -1;
  for (const MeasuredPoint& m : c.tests.points) trials += m.repeats;
  for (const MeasuredPoint& m : c.straight) {
    pull_spread = std::max(pull_spread, m.pull_spread_n / m.load_n);
    sinkage_spread_m = std::max(sinkage_spread_m, m.sinkage_spread_m);
    offset_low = std::min(offset_low, m.side_force_n / m.load_n);
    offset_high = std::max(offset_high, m.side_force_n / m.load_n);
  }
  t.paragraph(
      "{} trials in {} settings of slip and slip angle, averaged over their repeats (Yu, "
      "Pavlov, Kim and Johnson, J. Terramechanics 115, 2024): `cmu_single_wheel_smooth.csv`. "
      "Radius 62.5 mm, width 60 mm (recalled), travel at 10 mm/s. Bars in the figures span the "
      "repeats, which differ by up to {:.1f} % of the load in pull and {:.1f} mm in sinkage "
      "when rolling straight. The measured side force has an offset: at slip angle zero, where "
      "it should vanish, it is {:.3f} to {:.3f} of the load. It is not corrected.",
      trials, c.tests.points.size(), 100 * pull_spread, 1000 * sinkage_spread_m, offset_low,
      offset_high);
  t.paragraph(
      "The sand is not characterised. The start is dry sand of the Land Locomotion Laboratory "
      "(after Wong), and the bounds allow for another dry sand. Only straight rolling is fitted. "
      "It "
      "says little about cohesion, for which the middle between that sand's and none is taken. One "
      "shear modulus serves along and across the wheel.");
  parameters(t, c);
  t.add("\n![pull and sinkage against slip](validation/cmu_straight.svg)");
  straight_table(t, c, c.straight);
  t.add("\n### Slip angles to 45 deg, not refitted");
  t.paragraph(
      "No parameter is fitted to these points. They are no blind prediction all the same: that "
      "sinkage grows with the shear displacement, how that growth bends, that the side wall rubs, "
      "and the cohesion were chosen with all measurements of this rig in view.");
  t.add("\n![pull, side force and sinkage at slip angles](validation/cmu_slip_angles.svg)");
  turned_table(t, c, rolling_at(c.tests, {15, 30, 45}));
  t.add("\n### Beyond the model: 60 to 90 deg, and the locked wheel");
  t.paragraph("There the wheel is dragged more than it rolls. Reported; no aim is set.");
  t.add("\n![the same at large slip angles](validation/cmu_beyond.svg)");
  t.add("\n![the locked wheel](validation/cmu_locked.svg)");
  turned_table(t, c, rolling_at(c.tests, {60, 75, 90}));
  t.add("\nThe locked wheel:");
  turned_table(t, c, locked(c.tests));
}

// Least and greatest value of a quantity over the straight points of a case: "0.11 to 0.14".
template <class Quantity>
std::string range(const Case& c, const Soil& soil, int decimals, const Quantity& quantity) {
  const std::vector<SingleWheelPoint> answers = compute(soil, c.tests.wheel, c.straight);
  double low = 1e9, high = -1e9;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    low = std::min(low, quantity(c.straight[i], answers[i]));
    high = std::max(high, quantity(c.straight[i], answers[i]));
  }
  return fmt::format("{:.{}f} to {:.{}f}", low, decimals, high, decimals);
}

// Torque over radius minus pull, as a share of the load: all that the wheel spends on its rut.
std::string resistances(const Case& c) {
  const double R = c.tests.wheel.radius_m;
  const auto measured = [&](const MeasuredPoint& m, const SingleWheelPoint&) {
    return (m.torque_n_m / R - m.drawbar_pull_n) / m.load_n;
  };
  const auto computed = [&](const MeasuredPoint& m, const SingleWheelPoint& a) {
    return (a.torque_n_m / R - a.drawbar_pull_n) / m.load_n;
  };
  return fmt::format(
      "Torque over radius less pull, the resistance to rolling, is {} of the load as "
      "measured, {} with the fitted soil, {} with the published one.",
      range(c, c.fit.soil, 2, measured), range(c, c.fit.soil, 2, computed),
      range(c, c.published, 2, computed));
}

void ding(Text& t, const Case& c) {
  t.add("\n## Ding 2011: smooth wheel in a planetary simulant");
  t.paragraph(
      "Points read off a printed figure (Ding et al., J. Terramechanics 48(1), 2011, figure 9), "
      "so approximate: `single_wheel_smooth_published.csv`. Radius 157.35 mm, width 165 mm. The "
      "authors characterised the soil (table 2), the shear modulus as a range.");
  parameters(t, c);
  t.add("\n![pull, sinkage and torque against slip](validation/ding.svg)");
  straight_table(t, c, c.straight);
  t.paragraph("{}", resistances(c));
}

void kls(Text& t, const Case& c) {
  t.add("\n## KLS-1: smooth wheel in a lunar simulant");
  t.paragraph(
      "Points read off a printed figure (Wang and Han, J. Korean Geotech. Soc. 32(11), 2016, "
      "figure 14), so approximate: `single_wheel_smooth_published.csv`. Radius 85 mm, width 80 "
      "mm.");
  const Errors published = errors_of(c, c.published, c.straight);
  t.paragraph(
      "Shear strength is that of the same soil; the pressure-sinkage numbers come from the "
      "bevameter of another laboratory (Lim et al. 2021). With them the computed wheel stands "
      "{:.1f} times as deep as measured (geometric mean). The fit takes {:.4g} times their "
      "stiffness{}; that is no fit to a known soil but a sign that numbers and bin do not "
      "belong together.",
      published.sinkage_bias, c.fit.values[0],
      is_at_bound(c.parameters[0], c.fit.values[0]) ? ", which is the bound" : "");
  parameters(t, c);
  t.add("\n![pull, sinkage and torque against slip](validation/kls1.svg)");
  straight_table(t, c, c.straight);
  const auto deeper_mm = [](const MeasuredPoint& m, const SingleWheelPoint& a) {
    return 1000 * (a.sinkage_m - m.sinkage_m);
  };
  t.paragraph(
      "{} With the published soil, torque agrees to {:.1f} % of load x radius and the computed "
      "sinkage is above the measured one by {} mm, as it would be if the rig counted sinkage from "
      "the resting wheel; the data do not say. They are used as they stand.",
      resistances(c), 100 * published.torque, range(c, c.published, 1, deeper_mm));
}

void grousers(Text& t, const Cases& cases) {
  t.add("\n## Grousers of other heights");
  t.paragraph(
      "Measured wheels with grousers are in the tables of skill; nothing is fitted to them. "
      "Computed "
      "on the fitted soils under the mean load, slip by the rolling radius:");
  t.add("\n![pull of wheels with grousers](validation/grousers.svg)");
  t.add(
      "\n| wheel | grousers | pull / load at slip 0.2 | at 0.5 | at 0.9 |\n|---|---|---|---|---|");
  const auto row = [&](const Case& c, const std::string& what, const GrouserSet& g) {
    const double load_n = mean_load_n(c);
    const WheelSoil wheel_soil(c.fit.soil, with_grousers(c.tests.wheel, g), gravity_mps2);
    const auto pull = [&](double slip) {
      return single_wheel(wheel_soil, load_n, slip, 0).drawbar_pull_n / load_n;
    };
    const std::string rim =
        g.count == 0 ? "none" : fmt::format("{} of {:.0f} mm", g.count, 1000 * g.height_m);
    t.add("| {}, {:.1f} N | {} | {:.3f} | {:.3f} | {:.3f} |", what, load_n, rim, pull(0.2),
          pull(0.5), pull(0.9));
  };
  row(cases.cmu, "CMU", {});
  row(cases.cmu, "CMU", cmu_grousers);
  row(cases.ding, "Ding", {});
  for (const GrouserSet& g : ding_grousers) row(cases.ding, "Ding", g);
}

void limits(Text& t, const Cases& cases) {
  t.add(R"(
## Limits

* One contact point: how stress is spread along the wheel is not resolved; shear is that of the mean
  displacement.)");
  if (!sinkage_growth(cases.cmu).grows_braked) {
    t.add(
        R"(* Slip sinkage follows that mean displacement, which vanishes where a slightly braked wheel rolls
  freely, not at zero slip: there the computed sinkage is least, by up to a quarter. Sinkages of
  braked wheels were measured on CMU sand alone: 14.1 mm in the mean at slip 0, 14.7 at -0.2, and
  nothing between.)");
  }
  t.add(
      R"(* Resistance is compaction by the soil's pressure law and ploughing. Soil that piles up before and
  beside a wheel that is dragged is not followed.
* Two of the three soils are known from another laboratory or not at all, and the fits have few
  points: they show that the model can follow these wheels, not that it foretells another bin.
* The measurements are of small wheels under 20 to 80 N on Earth. Other gravities, speeds and loads
  are extrapolation.
* A first pass only: a second wheel in the track of a first was not measured.
* No wheel whose carcass yields is among the measured ones. The flattening of LRV's mesh is held to
  two published sentences only (its pull nearly at its most at a slip of 15 to 25 %, its energy on the
  level), and its rolling radius stays that of a rigid wheel.)");
}

}  // namespace

Cases fit_all(const std::string& data_folder) {
  return {cmu_case(data_folder), ding_case(data_folder), kls_case(data_folder)};
}

Wheel with_grousers(Wheel wheel, const GrouserSet& grousers) {
  wheel.grouser_height_m = grousers.height_m;
  wheel.grouser_count = grousers.count;
  return wheel;
}

double mean_load_n(const Case& c) {
  double sum_n = 0;
  for (const MeasuredPoint& m : c.straight) sum_n += m.load_n;
  return sum_n / static_cast<double>(c.straight.size());
}

Errors errors_of(const Case& c, const Soil& soil, const std::vector<MeasuredPoint>& points) {
  return errors(c.tests.wheel, points, compute(soil, c.tests.wheel, points));
}

Files report(const Cases& cases) {
  Text t;
  introduction(t);
  summary(t, cases);
  skill(t, cases);
  cmu(t, cases.cmu);
  ding(t, cases.ding);
  kls(t, cases.kls);
  grousers(t, cases);
  limits(t, cases);
  Files files = figures(cases);
  files["core/vehicle/VALIDATION.md"] = t.text;
  return files;
}

}  // namespace lsos::validation
