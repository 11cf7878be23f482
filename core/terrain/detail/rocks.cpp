#include "terrain/detail/rocks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lsos {

namespace {

constexpr double rock_cell_to_diameter = 8;

// Decay of the exponential law, q = 1.79 + 0.152 / cover, 1/m.
double decay_1pm(const RockPopulation& p) { return 1.79 + 0.152 / p.cover; }

// Number of rocks per m2 and per m of diameter.
double density_pm3(const RockPopulation& p, double diameter_m) {
  const double q = decay_1pm(p);
  return 4 / std::numbers::pi * p.cover * q * std::exp(-q * diameter_m) / (diameter_m * diameter_m);
}

// Sum over rocks of a quantity of each, per m2. Simpson's rule in the logarithm of the diameter,
// over an octave or less: exact to 1e-6.
template <class Of>
double sum_pm2(const RockPopulation& p, double low_m, double high_m, const Of& of) {
  constexpr int halves = 8;
  const double step = std::log(high_m / low_m) / (2 * halves);
  double sum = 0;
  for (int k = 0; k <= 2 * halves; ++k) {
    const double diameter_m = low_m * std::exp(k * step);
    const double weight = k == 0 || k == 2 * halves ? 1 : k % 2 == 1 ? 4 : 2;
    sum += weight * density_pm3(p, diameter_m) * diameter_m * of(diameter_m);
  }
  return sum * step / 3;
}

double number_pm2(const RockPopulation& p, double low_m, double high_m) {
  return sum_pm2(p, low_m, high_m, [](double) { return 1.0; });
}

// Draws a diameter of the octave: from D^-2, accepted with the probability of the exponential.
double rock_diameter_m(const RockPopulation& p, double low_m, double high_m, RandomStream& random) {
  const double q = decay_1pm(p);
  for (;;) {
    const double diameter_m = 1 / (1 / low_m + random.uniform() * (1 / high_m - 1 / low_m));
    if (random.uniform() < std::exp(-q * (diameter_m - low_m))) return diameter_m;
  }
}

}  // namespace

double rock_cover(const RockPopulation& population, double diameter_m) {
  return population.cover * std::exp(-decay_1pm(population) * diameter_m);
}

double rocks_pm2(const RockPopulation& p, double diameter_m) {
  double sum = 0;
  for (double low = diameter_m; low < p.diameter_max_m; low *= 2) {
    sum += number_pm2(p, low, std::min(2 * low, p.diameter_max_m));
  }
  return sum;
}

double rock_volume_m3(const Rock& rock) {
  const double radius_m = rock.diameter_m / 2;
  return 8.0 / 15 * std::numbers::pi * radius_m * radius_m * rock.height_m;
}

double rock_volume_pm2(const RockPopulation& p, double low_m, double high_m) {
  double sum = 0;
  for (double low = std::max(low_m, p.diameter_min_m); low < std::min(high_m, p.diameter_max_m);
       low *= 2) {
    sum += sum_pm2(p, low, std::min({2 * low, high_m, p.diameter_max_m}), [&p](double diameter_m) {
      return rock_volume_m3({{}, diameter_m, p.height_to_diameter * diameter_m});
    });
  }
  return sum;
}

std::vector<Rock> rocks_touching(const RockPopulation& p, std::uint64_t seed,
                                 const PlaneRectangle& area, double diameter_low_m,
                                 double diameter_high_m) {
  std::vector<Rock> rocks;
  std::uint64_t octave = 0;
  for (double low = p.diameter_min_m; low < p.diameter_max_m; low *= 2, ++octave) {
    const double high = std::min(2 * low, p.diameter_max_m);
    if (high <= diameter_low_m || low >= diameter_high_m) continue;
    const std::uint64_t key = mix_key(mix_key(seed, "rocks"), octave);
    const double reach_m = high / 2;
    const PlaneRectangle around{{area.low.x_m - reach_m, area.low.y_m - reach_m},
                                {area.high.x_m + reach_m, area.high.y_m + reach_m}};
    visit_points(key, number_pm2(p, low, high), rock_cell_to_diameter * high, around,
                 [&](const PlanePoint& at, RandomStream& random) {
                   const double diameter_m = rock_diameter_m(p, low, high, random);
                   if (diameter_m < diameter_low_m || diameter_m >= diameter_high_m) return;
                   const double dx = at.x_m - std::clamp(at.x_m, area.low.x_m, area.high.x_m);
                   const double dy = at.y_m - std::clamp(at.y_m, area.low.y_m, area.high.y_m);
                   if (dx * dx + dy * dy >= diameter_m * diameter_m / 4) return;
                   rocks.push_back({at, diameter_m, p.height_to_diameter * diameter_m});
                 });
  }
  return rocks;
}

}  // namespace lsos
