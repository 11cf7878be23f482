#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/report.h"

namespace lsos::validation {

namespace {

constexpr double zero_slip_aim = 0.05;  // of the load

// A remark that lists the points whose sinkage misses the aim.
std::string worst_sinkages(const Case& c) {
  const std::vector<SingleWheelPoint> answers = compute(c.fit.soil, c.tests.wheel, c.straight);
  std::string list;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const double ratio = answers[i].sinkage_m / c.straight[i].sinkage_m;
    if (std::max(ratio, 1 / ratio) <= sinkage_aim) continue;
    list += fmt::format("{} slip {:.1f} ({:.1f} mm measured, {:.1f} computed)",
                        list.empty() ? "; missed at" : ",", c.straight[i].slip,
                        1000 * c.straight[i].sinkage_m, 1000 * answers[i].sinkage_m);
  }
  return list;
}

Aim pull_at_zero_slip(const Case& c) {
  const std::vector<SingleWheelPoint> answers = compute(c.fit.soil, c.tests.wheel, c.straight);
  const auto at = std::ranges::min_element(c.straight, {},
                                           [](const MeasuredPoint& m) { return std::abs(m.slip); });
  const double computed_n = answers[at - c.straight.begin()].drawbar_pull_n;
  const double error = std::abs(computed_n - at->drawbar_pull_n) / at->load_n;
  return {c.name + ": pull at zero slip",
          fmt::format("within {:.0f} % of the load", 100 * zero_slip_aim),
          fmt::format("{:.3f} of the load measured, {:.3f} computed",
                      at->drawbar_pull_n / at->load_n, computed_n / at->load_n),
          error <= zero_slip_aim};
}

std::string growth_found(const SinkageGrowth& g) {
  std::string found = fmt::format("driven {}; braked {}", g.grows_driven ? "yes" : "no",
                                  g.grows_braked ? "yes" : "no");
  if (!g.grows_braked) {
    found += fmt::format(", it is least at slip {:.2f}: {:.1f} % below that at zero",
                         g.least_at_slip, 100 * (1 - g.at_least_m / g.at_zero_m));
  }
  return found;
}

double pull_of(const Case& c, const Wheel& wheel, double slip) {
  const WheelSoil wheel_soil(c.fit.soil, wheel, gravity_mps2);
  return single_wheel(wheel_soil, mean_load_n(c), slip, 0).drawbar_pull_n;
}

}  // namespace

std::vector<Aim> aims(const Cases& cases) {
  std::vector<Aim> list;
  const auto at_most = [&](const std::string& what, double value, double limit) {
    list.push_back({what, fmt::format("at most {:.0f} % of the load", 100 * limit),
                    fmt::format("{:.1f} %", 100 * value), value <= limit});
  };
  for (const Case* c : {&cases.cmu, &cases.ding, &cases.kls}) {
    const Errors e = errors_of(*c, c->fit.soil, c->straight);
    at_most(c->name + ": straight, RMS error of the pull", e.pull, pull_aim);
    list.push_back({c->name + ": straight, sinkage at each point",
                    fmt::format("within a factor of {}", sinkage_aim),
                    fmt::format("{:.2f}{}", e.sinkage_worst, worst_sinkages(*c)),
                    e.sinkage_worst <= sinkage_aim});
  }
  list.push_back(pull_at_zero_slip(cases.cmu));
  list.push_back(pull_at_zero_slip(cases.ding));
  for (const Case* c : {&cases.cmu, &cases.ding, &cases.kls}) {
    const SinkageGrowth g = sinkage_growth(*c);
    list.push_back({c->name + ": sinkage grows with slip", "both ways from zero", growth_found(g),
                    g.grows_driven && g.grows_braked});
  }
  const std::vector<MeasuredPoint> turned = rolling_at(cases.cmu.tests, {15, 30, 45});
  const Errors e = errors_of(cases.cmu, cases.cmu.fit.soil, turned);
  at_most("CMU sand: slip angles 15 to 45 deg, RMS error of the pull", e.pull, turned_pull_aim);
  at_most("CMU sand: slip angles 15 to 45 deg, RMS error of the side force", e.side,
          turned_side_aim);

  const auto blind = [&](const std::string& what, const Case& c,
                         const std::vector<double>& slip_angles_deg, double limit) {
    const std::vector<MeasuredPoint> points = rolling_at(c.grousered, slip_angles_deg);
    at_most(what + ", RMS error of the pull",
            errors(c.grousered.wheel, points, compute(c.fit.soil, c.grousered.wheel, points)).pull,
            limit);
  };
  blind("CMU sand: grousers of 4.9 mm, straight", cases.cmu, {0}, pull_aim);
  blind("CMU sand: grousers of 4.9 mm, 0 to 45 deg", cases.cmu, {0, 15, 30, 45}, 0.15);
  blind("Ding 2011: lugs of 10 mm", cases.ding, {0}, pull_aim);

  // The smooth rim is compared with grousers from low to high: each must pull more than the one
  // before.
  const Wheel &cmu = cases.cmu.tests.wheel, &ding = cases.ding.tests.wheel;
  bool is_more = true;
  double most = 0;  // pull over load
  for (int percent = 20; percent <= 90; percent += 10) {
    const double slip = percent / 100.0;
    is_more &=
        pull_of(cases.cmu, with_grousers(cmu, cmu_grousers), slip) > pull_of(cases.cmu, cmu, slip);
    double before_n = pull_of(cases.ding, ding, slip);
    for (const GrouserSet& g : ding_grousers) {
      const double pull_n = pull_of(cases.ding, with_grousers(ding, g), slip);
      is_more &= pull_n > before_n;
      most = std::max(most, pull_n / mean_load_n(cases.ding));
      before_n = pull_n;
    }
  }
  list.push_back({"grousers pull more than the smooth wheel, higher ones more than lower",
                  "slip 0.2 to 0.9", is_more ? "at every slip" : "not at every slip", is_more});
  list.push_back({"greatest pull of those wheels",
                  fmt::format("at most {:.0f} % of the load", 100 * pull_share_max),
                  fmt::format("{:.1f} %", 100 * most), most <= pull_share_max});
  return list;
}

}  // namespace lsos::validation
