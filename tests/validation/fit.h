// Fit of soil parameters within stated bounds to measurements with the wheel model, and the
// remaining errors.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "validation/wheel_data.h"
#include "vehicle/single_wheel.h"

namespace lsos::validation {

inline constexpr double gravity_mps2 = 9.81;  // all measurements were made on Earth

// A parameter that may be fitted. Its values lie on a grid from `low` in steps of `step`, which
// makes the result equal to the last digit on every machine.
struct FitParameter {
  std::string name;       // as printed in tables, with its unit
  std::string published;  // value in the source of the soil
  double low = 0, high = 0, step = 1;
  double start = 0;
  std::function<void(Soil&, double value)> set;
};

// Parameters of all soils, in the units of the tables.
FitParameter stiffness_factor(double low, double high, double step);  // of k_c and k_phi
FitParameter cohesion(const Soil& soil, double low_pa, double high_pa, double step_pa);
FitParameter friction(const Soil& soil, double low_deg, double high_deg, double step_deg);
FitParameter shear_modulus(const Soil& soil, double low_m, double high_m, double step_m);
FitParameter slip_sinkage(double low, double high, double step);

// Aims of the model on straight rolling, which also weight the errors of pull and sinkage in the
// fit.
inline constexpr double pull_aim = 0.1;         // root mean square, of the load
inline constexpr double sinkage_aim = 1.5;      // computed over measured or its inverse
inline constexpr double turned_pull_aim = 0.2;  // at slip angles to 45 deg
inline constexpr double turned_side_aim = 0.3;

struct Fit {
  Soil soil;
  std::vector<double> values;  // one for each parameter
};

// Minimises mean (pull error / load)^2 / pull_aim^2 + mean ln(sinkage ratio)^2 / ln(sinkage_aim)^2
// by a pattern search from several starts.
Fit fit_soil(const Soil& published, const Wheel& wheel, std::span<const MeasuredPoint> points,
             std::span<const FitParameter> parameters);

std::vector<SingleWheelPoint> compute(const Soil& soil, const Wheel& wheel,
                                      std::span<const MeasuredPoint> points);

// Root mean squares; forces as shares of the load, torque as a share of load x radius. NaN: not
// measured.
struct Errors {
  int count = 0;
  double pull = 0, side = 0, torque = 0;
  double sinkage_worst = 1;    // greatest factor between computed and measured, >= 1
  double sinkage_typical = 1;  // exp of the root mean square logarithm
  double sinkage_bias = 1;     // geometric mean of computed over measured
};
Errors errors(const Wheel& wheel, std::span<const MeasuredPoint> measured,
              std::span<const SingleWheelPoint> computed);

}  // namespace lsos::validation
