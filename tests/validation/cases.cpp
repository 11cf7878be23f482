#include "validation/cases.h"

#include <fmt/format.h>

#include <cmath>

#include "base/units.h"

namespace lsos::validation {

namespace {

// `start`: what is not fitted, and where the search begins.
void fit(Case& c, const Soil& start) {
  c.straight = rolling_at(c.tests, 0);
  c.fit = fit_soil(start, c.tests.wheel, c.straight, c.parameters);
}

Constant interface_ratio() {
  return {"interface friction ratio of the rim", "-",
          fmt::format("{}, default of the program", Wheel{}.interface_friction_ratio)};
}

constexpr const char* scaled = "as published, but for the common factor";

}  // namespace

Case cmu_case(const std::string& folder) {
  Case c;
  c.name = "CMU sand";
  c.tests = read_cmu_tests(folder, false);
  c.grousered = read_cmu_tests(folder, true);
  // Dry sand of the Land Locomotion Laboratory (Wong): the sand of the rig is not characterised.
  c.published = {.name = "DrySand",
                 .k_c = 990,
                 .k_phi = 1528430,
                 .n = 1.1,
                 .cohesion_pa = 1040,
                 .friction_rad = radians(28),
                 .density_kgpm3 = 1600,
                 .shear_modulus_x_m = 0.015,
                 .shear_modulus_y_m = 0.015};
  // Straight rolling says little about cohesion: over 0 to 1040 Pa the error of the pull changes by
  // a hundredth of the load.
  Soil start = c.published;
  start.cohesion_pa = 520;
  c.parameters = {stiffness_factor(0.7, 1.4, 0.01), friction(c.published, 28, 36, 0.1),
                  shear_modulus(c.published, 0.010, 0.025, 0.0001), slip_sinkage(0.3, 3, 0.01)};
  c.parameters[2].published = "10 to 25";
  c.constants = {{"k_c, k_phi, n", "990, 1528430, 1.1", scaled},
                 {"cohesion, Pa", "1040", "520, the middle of 0 to 1040"},
                 {"density, kg/m3", "-", "1600, assumed"},
                 interface_ratio(),
                 {"wheel width, mm", "-", "60, recalled, not in the data"}};
  fit(c, start);
  return c;
}

Case ding_case(const std::string& folder) {
  Case c;
  c.name = "Ding 2011";
  c.tests = read_published_tests(folder, "ding2011", false);
  c.grousered = read_published_tests(folder, "ding2011", true);
  c.published = {.name = "Ding2011_planetary_simulant",
                 .k_c = 15.6e3,
                 .k_phi = 2407.4e3,
                 .n = 1.10,
                 .cohesion_pa = 250,
                 .friction_rad = radians(31.9),
                 .density_kgpm3 = 1605,
                 .shear_modulus_x_m = 0.011,
                 .shear_modulus_y_m = 0.011};
  c.parameters = {stiffness_factor(0.5, 2.5, 0.01), friction(c.published, 28.7, 35.1, 0.1),
                  shear_modulus(c.published, 0.0097, 0.0131, 0.0001), slip_sinkage(0.3, 6, 0.01)};
  c.parameters[2].published = "9.7 to 13.1";
  c.constants = {{"k_c, k_phi, n", "15600, 2407400, 1.1", scaled},
                 {"cohesion, Pa", "250", "as published"},
                 {"density, kg/m3", "1605", "as published"},
                 interface_ratio()};
  fit(c, c.published);
  return c;
}

Case kls_case(const std::string& folder) {
  Case c;
  c.name = "KLS-1";
  c.tests = read_published_tests(folder, "wang_han_2016_kls1", false);
  c.published = {.name = "KLS-1",
                 .k_c = -44055.4,
                 .k_phi = 3581810.6,
                 .n = 1.2594,
                 .cohesion_pa = 1716,
                 .friction_rad = radians(40.6),
                 .density_kgpm3 = 1600,
                 .shear_modulus_x_m = 0.018,
                 .shear_modulus_y_m = 0.018};
  c.parameters = {stiffness_factor(0.5, 40, 0.1), friction(c.published, 36.5, 44.7, 0.1),
                  shear_modulus(c.published, 0.009, 0.027, 0.0001), slip_sinkage(0.3, 6, 0.01)};
  c.constants = {{"k_c, k_phi, n", "-44055.4, 3581810.6, 1.2594", scaled},
                 {"cohesion, Pa", "1716", "as published"},
                 {"density, kg/m3", "1600", "as published"},
                 interface_ratio()};
  fit(c, c.published);
  return c;
}

std::vector<MeasuredPoint> rolling_at(const WheelTests& tests, double slip_angle_deg) {
  return rolling_at(tests, std::vector{slip_angle_deg});
}

std::vector<MeasuredPoint> rolling_at(const WheelTests& tests,
                                      const std::vector<double>& slip_angles_deg) {
  std::vector<MeasuredPoint> points;
  for (const double angle_deg : slip_angles_deg) {
    for (const MeasuredPoint& p : tests.points) {
      const bool is_there = std::abs(degrees(p.slip_angle_rad) - angle_deg) < 0.5;
      if (is_there && p.slip > -0.99) points.push_back(p);
    }
  }
  return points;
}

std::vector<MeasuredPoint> locked(const WheelTests& tests) {
  std::vector<MeasuredPoint> points;
  for (const MeasuredPoint& p : tests.points) {
    if (p.slip <= -0.99) points.push_back(p);
  }
  return points;
}

SinkageGrowth sinkage_growth(const Case& c) {
  double load_n = 0;
  for (const MeasuredPoint& p : c.straight)
    load_n += p.load_n / static_cast<double>(c.straight.size());
  const WheelSoil wheel_soil(c.fit.soil, c.tests.wheel, gravity_mps2);
  const double rolling_radius_m = wheel_soil.rolling_radius_m(load_n);
  const auto at = [&](int percent) {
    const double slip =
        slip_by(rolling_radius_m, percent / 100.0, c.straight.front().slip_radius_m);
    return single_wheel(wheel_soil, load_n, slip, 0).sinkage_m;
  };
  constexpr int stride = 2;
  SinkageGrowth growth{
      .at_least_m = at(0), .at_zero_m = at(0), .grows_driven = true, .grows_braked = true};
  double before_m = growth.at_zero_m;
  for (int percent = stride; percent <= 90; percent += stride) {
    const double z_m = at(percent);
    growth.grows_driven &= z_m > before_m;
    before_m = z_m;
  }
  before_m = growth.at_zero_m;
  for (int percent = -stride; percent >= -70; percent -= stride) {
    const double z_m = at(percent);
    growth.grows_braked &= z_m > before_m;
    if (z_m < growth.at_least_m) {
      growth.at_least_m = z_m;
      growth.least_at_slip = percent / 100.0;
    }
    before_m = z_m;
  }
  return growth;
}

}  // namespace lsos::validation
