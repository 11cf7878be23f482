#include "validation/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/units.h"

namespace lsos::validation {

namespace {

double squared(double x) { return x * x; }

// A grid point: steps from `low`, one number for each parameter.
using GridPoint = std::vector<int>;

class GridSearch {
 public:
  GridSearch(const Soil& published, const Wheel& wheel, std::span<const MeasuredPoint> points,
             std::span<const FitParameter> parameters)
      : published_(published), wheel_(wheel), points_(points), parameters_(parameters) {
    for (const FitParameter& p : parameters) {
      steps_.push_back(static_cast<int>(std::lround((p.high - p.low) / p.step)));
    }
  }

  Fit fit(const GridPoint& at) const {
    Fit fit{published_, {}};
    for (std::size_t i = 0; i < at.size(); ++i) {
      fit.values.push_back(parameters_[i].low + at[i] * parameters_[i].step);
      parameters_[i].set(fit.soil, fit.values.back());
    }
    return fit;
  }

  // Descends from `at` along one parameter or two at a time, in strides that halve when none
  // improves the cost.
  GridPoint descend(GridPoint at) {
    for (int part = 4; part <= 1024; part *= 2) {
      while (step_downhill(at, part)) {
      }
    }
    return at;
  }

  GridPoint start(double share_to_bound) const {
    GridPoint at;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const FitParameter& p = parameters_[i];
      const double end = share_to_bound < 0 ? p.low : p.high;
      const double value = p.start + std::abs(share_to_bound) * (end - p.start);
      at.push_back(
          std::clamp(static_cast<int>(std::lround((value - p.low) / p.step)), 0, steps_[i]));
    }
    return at;
  }

  double cost(const GridPoint& at) {
    const auto [it, is_new] = known_.try_emplace(at, 0);
    if (is_new) {
      const Errors e = errors(wheel_, points_, compute(fit(at).soil, wheel_, points_));
      it->second =
          squared(e.pull / pull_aim) + squared(std::log(e.sinkage_typical) / std::log(sinkage_aim));
    }
    return it->second;
  }

 private:
  // Accepts every improving step at once.
  bool step_downhill(GridPoint& at, int part) {
    bool is_better = false;
    const auto offer = [&](const GridPoint& next) {
      if (cost(next) >= cost(at)) return;
      at = next;
      is_better = true;
    };
    const auto count = static_cast<int>(at.size());
    for (int i = 0; i < count; ++i) {
      for (const int by : {-1, 1}) {
        offer(moved(at, i, by, part));
        for (int k = 0; k < i; ++k) {
          for (const int also : {-1, 1}) offer(moved(moved(at, i, by, part), k, also, part));
        }
      }
    }
    return is_better;
  }

  GridPoint moved(GridPoint at, int i, int by, int part) const {
    const int stride = std::max(1, steps_[i] / part);
    at[i] = std::clamp(at[i] + by * stride, 0, steps_[i]);
    return at;
  }

  const Soil& published_;
  const Wheel& wheel_;
  std::span<const MeasuredPoint> points_;
  std::span<const FitParameter> parameters_;
  std::vector<int> steps_;
  std::map<GridPoint, double> known_;
};

}  // namespace

FitParameter stiffness_factor(double low, double high, double step) {
  return {"factor on k_c and k_phi", "1", low, high, step, 1, [](Soil& soil, double factor) {
            soil.k_c *= factor;
            soil.k_phi *= factor;
          }};
}

FitParameter cohesion(const Soil& soil, double low_pa, double high_pa, double step_pa) {
  return {"cohesion, Pa",
          fmt::format("{:.4g}", soil.cohesion_pa),
          low_pa,
          high_pa,
          step_pa,
          soil.cohesion_pa,
          [](Soil& s, double value_pa) { s.cohesion_pa = value_pa; }};
}

FitParameter friction(const Soil& soil, double low_deg, double high_deg, double step_deg) {
  const double published_deg = degrees(soil.friction_rad);
  return {"friction angle, deg",
          fmt::format("{:.4g}", published_deg),
          low_deg,
          high_deg,
          step_deg,
          published_deg,
          [](Soil& s, double value_deg) { s.friction_rad = radians(value_deg); }};
}

FitParameter shear_modulus(const Soil& soil, double low_m, double high_m, double step_m) {
  return {"shear modulus K, mm",
          fmt::format("{:.4g}", 1000 * soil.shear_modulus_x_m),
          1000 * low_m,
          1000 * high_m,
          1000 * step_m,
          1000 * soil.shear_modulus_x_m,
          [](Soil& s, double value_mm) {
            s.shear_modulus_x_m = s.shear_modulus_y_m = value_mm / 1000;
          }};
}

FitParameter slip_sinkage(double low, double high, double step) {
  return {"slip sinkage a", "none", low, high, step, 1, [](Soil& soil, double value) {
            soil.slip_sinkage = value;
          }};
}

std::vector<SingleWheelPoint> compute(const Soil& soil, const Wheel& wheel,
                                      std::span<const MeasuredPoint> points) {
  const WheelSoil wheel_soil(soil, wheel, gravity_mps2);
  std::vector<SingleWheelPoint> computed;
  for (const MeasuredPoint& p : points) {
    const double slip = slip_by(wheel_soil.rolling_radius_m(p.load_n), p.slip, p.slip_radius_m);
    computed.push_back(single_wheel(wheel_soil, p.load_n, slip, p.slip_angle_rad));
  }
  return computed;
}

Fit fit_soil(const Soil& published, const Wheel& wheel, std::span<const MeasuredPoint> points,
             std::span<const FitParameter> parameters) {
  GridSearch search(published, wheel, points, parameters);
  // The cost has several local minima: start at the published values and half-share to the bounds.
  GridPoint best;
  for (const double share : {0.0, -0.5, 0.5}) {
    const GridPoint end = search.descend(search.start(share));
    if (best.empty() || search.cost(end) < search.cost(best)) best = end;
  }
  return search.fit(best);
}

Errors errors(const Wheel& wheel, std::span<const MeasuredPoint> measured,
              std::span<const SingleWheelPoint> computed) {
  Errors e;
  double log_sum = 0, log_squares = 0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const MeasuredPoint& m = measured[i];
    const SingleWheelPoint& c = computed[i];
    ++e.count;
    e.pull += squared((c.drawbar_pull_n - m.drawbar_pull_n) / m.load_n);
    e.side += squared((c.side_force_n - m.side_force_n) / m.load_n);
    e.torque += squared((c.torque_n_m - m.torque_n_m) / (m.load_n * wheel.radius_m));
    const double ratio = std::log(c.sinkage_m / m.sinkage_m);
    log_sum += ratio;
    log_squares += ratio * ratio;
    e.sinkage_worst = std::max(e.sinkage_worst, std::exp(std::abs(ratio)));
  }
  for (double* sum : {&e.pull, &e.side, &e.torque}) *sum = std::sqrt(*sum / e.count);
  e.sinkage_typical = std::exp(std::sqrt(log_squares / e.count));
  e.sinkage_bias = std::exp(log_sum / e.count);
  return e;
}

}  // namespace lsos::validation
