#include "terrain/detail/craters.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace lsos {

namespace {

// Diameters are drawn octave by octave, each on its own grid with cells of this many diameters, so
// that a query at one place meets few cells, whatever the range of diameters.
constexpr double crater_cell_to_diameter = 4;

// A crater's life ends when its depth is down to 0.04 of its diameter, a fifth of a fresh one's
// (Fassett and Thomson 2014). Diffusion lowers a smooth hollow by 1 / (1 + 4 lived), with `lived`
// in 0..1; the narrower rim goes down with the square of that, an assumption.
constexpr double depth_lost_at_end = 4;

struct Octave {
  int number;
  double diameter_low_m;
  double diameter_high_m;
  double cumulative_low_pm2;
  double cumulative_high_pm2;
  double exponent = 0;             // of the power law D(N) through the octave's ends
  bool is_in_equilibrium = false;  // all its sizes have reached equilibrium
};

// Greatest share of its life that a crater of this size has lived.
double life_max(const CraterPopulation& p, double diameter_m) {
  if (!p.age_gyr) return p.degradation.value_or(0);
  const double filled =
      crater_production_pm2(*p.age_gyr, diameter_m) / crater_equilibrium_pm2(diameter_m);
  return p.degradation.value_or(1) * std::min(1.0, filled);
}

// Octaves of diameter that have craters.
std::vector<Octave> octaves(const CraterPopulation& p) {
  std::vector<Octave> result;
  int number = 0;
  for (double low = p.diameter_min_m; low < p.diameter_max_m; low *= 2, ++number) {
    const double high = std::min(2 * low, p.diameter_max_m);
    Octave octave{number, low, high, cumulative_pm2(p, low), cumulative_pm2(p, high)};
    if (!(octave.cumulative_high_pm2 < octave.cumulative_low_pm2)) continue;
    const double ratio = octave.cumulative_high_pm2 / octave.cumulative_low_pm2;
    octave.exponent = std::log(high / low) / std::log(ratio);
    // Within an octave the ratio of production to equilibrium is monotonic: its ends decide.
    const auto is_in_equilibrium = [&](double diameter_m) {
      return p.age_gyr &&
             crater_production_pm2(*p.age_gyr, diameter_m) >= crater_equilibrium_pm2(diameter_m);
    };
    octave.is_in_equilibrium = is_in_equilibrium(low) && is_in_equilibrium(high);
    result.push_back(octave);
  }
  return result;
}

// Diameter below which that share of the octave's craters lies: the inverse of share_below().
double crater_diameter_m(const Octave& o, double share) {
  const double ratio = o.cumulative_high_pm2 / o.cumulative_low_pm2;
  return o.diameter_low_m * std::pow(1 + share * (ratio - 1), o.exponent);
}

// Share of the octave's craters that are not larger, by the power law through the octave's ends.
double share_below(const Octave& o, double diameter_m) {
  const double ratio = o.cumulative_high_pm2 / o.cumulative_low_pm2;
  return (std::pow(diameter_m / o.diameter_low_m, 1 / o.exponent) - 1) / (ratio - 1);
}

double life_max(const CraterPopulation& p, const Octave& o, double diameter_m) {
  return o.is_in_equilibrium ? p.degradation.value_or(1) : life_max(p, diameter_m);
}

// Crater that has lived that share of its life.
Crater degraded_crater(const CraterPopulation& p, const PlanePoint& at, double diameter_m,
                       double lived) {
  const double left = 1 / (1 + depth_lost_at_end * lived);
  const double fresh_m = p.depth_to_diameter * diameter_m;
  return {at, diameter_m, fresh_m * left, rim_to_depth * fresh_m * left * left};
}

}  // namespace

double crater_production_pm2(double age_gyr, double diameter_m) {
  constexpr double a[] = {0,        -3.557528, 0.781027,  1.021521,  -0.156012, -0.444058,
                          0.019977, 0.086850,  -0.005874, -0.006809, 8.25e-4,   5.54e-5};
  constexpr double smallest_m = 10, small_exponent = -3;
  const double x = std::log10(std::max(diameter_m, smallest_m) / 1000);
  double log_n = 0;
  for (int j = 11; j >= 0; --j) log_n = log_n * x + a[j];
  const double larger_than_1_km_pm2 =
      1e-6 * (5.44e-14 * std::expm1(6.93 * age_gyr) + 8.38e-4 * age_gyr);
  const double below = std::min(diameter_m / smallest_m, 1.0);
  return larger_than_1_km_pm2 * std::pow(10.0, log_n) * std::pow(below, small_exponent);
}

double crater_equilibrium_pm2(double diameter_m) {
  return std::pow(10.0, -1.1) / (diameter_m * diameter_m);
}

double cumulative_pm2(const CraterPopulation& p, double diameter_m) {
  if (!p.age_gyr) return p.density_pm2 * std::pow(diameter_m / p.diameter_min_m, -p.exponent);
  return std::min(crater_production_pm2(*p.age_gyr, diameter_m),
                  crater_equilibrium_pm2(diameter_m));
}

// Midpoint rule over equal parts of the craters drawn, by size and by age.
double crater_volume_pm2(const CraterPopulation& p, double low_m, double high_m) {
  constexpr int parts = 16;
  double sum_pm2 = 0;
  for (const Octave& octave : octaves(p)) {
    const double low = std::max(low_m, octave.diameter_low_m);
    const double high = std::min(high_m, octave.diameter_high_m);
    if (low >= high) continue;
    const double from = share_below(octave, low), to = share_below(octave, high);
    double sum_m3 = 0;
    for (int i = 0; i < parts; ++i) {
      const double diameter_m = crater_diameter_m(octave, from + (i + 0.5) / parts * (to - from));
      const double most = life_max(p, octave, diameter_m);
      for (int j = 0; j < parts; ++j) {
        sum_m3 += crater_volume_m3(degraded_crater(p, {}, diameter_m, (j + 0.5) / parts * most));
      }
    }
    sum_pm2 += (octave.cumulative_low_pm2 - octave.cumulative_high_pm2) * (to - from) * sum_m3 /
               (parts * parts);
  }
  LSOS_ASSERT(std::isfinite(sum_pm2));
  return sum_pm2;
}

std::vector<Crater> craters_touching(const CraterPopulation& population, std::uint64_t seed,
                                     const PlaneRectangle& area, double diameter_low_m,
                                     double diameter_high_m) {
  std::vector<Crater> craters;
  for (const Octave& octave : octaves(population)) {
    if (octave.diameter_high_m <= diameter_low_m || octave.diameter_low_m >= diameter_high_m) {
      continue;
    }
    const double reach_m = crater_reach * octave.diameter_high_m / 2;
    const std::uint64_t key =
        mix_key(mix_key(seed, "craters"), static_cast<std::uint64_t>(octave.number));
    const PlaneRectangle around{{area.low.x_m - reach_m, area.low.y_m - reach_m},
                                {area.high.x_m + reach_m, area.high.y_m + reach_m}};
    visit_points(key, octave.cumulative_low_pm2 - octave.cumulative_high_pm2,
                 crater_cell_to_diameter * octave.diameter_high_m, around,
                 [&](const PlanePoint& at, RandomStream& random) {
                   const double diameter_m = crater_diameter_m(octave, random.uniform());
                   const double lived = random.uniform();
                   if (diameter_m < diameter_low_m || diameter_m >= diameter_high_m) return;
                   const double dx = at.x_m - std::clamp(at.x_m, area.low.x_m, area.high.x_m);
                   const double dy = at.y_m - std::clamp(at.y_m, area.low.y_m, area.high.y_m);
                   const double touch_m = crater_reach * diameter_m / 2;
                   if (dx * dx + dy * dy >= touch_m * touch_m) return;
                   const double most = life_max(population, octave, diameter_m);
                   craters.push_back(degraded_crater(population, at, diameter_m, lived * most));
                 });
  }
  return craters;
}

}  // namespace lsos
