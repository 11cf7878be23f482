#include "terrain/craters.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace lsos {

namespace {

// Pike 1977 (Size-dependence in the shape of fresh impact craters on the Moon): simple craters have
// depth 0.196 D and rim height 0.036 D. Older craters have both subdued; the ratio is kept.
constexpr double rim_to_depth = 0.036 / 0.196;

// The bowl is a parabola to this share of the radius and a rounded crest from there on.
constexpr double bowl_share = 0.8;

// Diameters are drawn octave by octave, each on its own grid of cells of this many diameters, so
// that a look at one place meets few cells, whatever the range of diameters.
constexpr double cell_to_diameter = 4;

// Knuth's method multiplies uniforms until they pass exp(-mean); in portions, so that the
// exponential does not underflow.
int poisson(double mean, RandomStream& random) {
  int count = 0;
  for (double rest = mean; rest > 0; rest -= 16) {
    const double limit = std::exp(-std::min(rest, 16.0));
    for (double product = random.uniform(); product > limit; product *= random.uniform()) ++count;
  }
  return count;
}

struct Octave {
  int number;
  double diameter_low_m;
  double diameter_high_m;
  double mean_pm2;  // craters with a diameter in this octave
};

double cumulative_pm2(const CraterSurface& s, double diameter_m) {
  return s.density_pm2 * std::pow(diameter_m / s.diameter_min_m, -s.exponent);
}

std::vector<Octave> octaves(const CraterSurface& s) {
  std::vector<Octave> result;
  for (double low = s.diameter_min_m; low < s.diameter_max_m; low *= 2) {
    const double high = std::min(2 * low, s.diameter_max_m);
    result.push_back({static_cast<int>(result.size()), low, high,
                      cumulative_pm2(s, low) - cumulative_pm2(s, high)});
  }
  return result;
}

// The inverse of the cumulative power law between the octave's ends.
double drawn_diameter_m(const CraterSurface& s, const Octave& octave, double share) {
  const double low = std::pow(octave.diameter_low_m, -s.exponent);
  const double high = std::pow(octave.diameter_high_m, -s.exponent);
  return std::pow(low + share * (high - low), -1 / s.exponent);
}

void add_cell(const CraterSurface& s, std::uint64_t seed, const Octave& octave, double cell_m,
              std::int64_t column, std::int64_t row, std::vector<Crater>& craters) {
  std::uint64_t key = mix_key(mix_key(seed, "craters"), static_cast<std::uint64_t>(octave.number));
  key = mix_key(mix_key(key, static_cast<std::uint64_t>(column)), static_cast<std::uint64_t>(row));
  RandomStream random(key);
  for (int rest = poisson(octave.mean_pm2 * cell_m * cell_m, random); rest > 0; --rest) {
    Crater crater;
    crater.centre.x_m = (static_cast<double>(column) + random.uniform()) * cell_m;
    crater.centre.y_m = (static_cast<double>(row) + random.uniform()) * cell_m;
    crater.diameter_m = drawn_diameter_m(s, octave, random.uniform());
    craters.push_back(crater);
  }
}

}  // namespace

double crater_height_m(double distance_m, double diameter_m, double depth_to_diameter) {
  const double r = distance_m / (diameter_m / 2);
  if (r >= crater_reach) return 0;
  const double depth_m = depth_to_diameter * diameter_m;  // rim crest to floor
  const double rim_m = rim_to_depth * depth_m;
  if (r <= bowl_share) return rim_m - depth_m + depth_m / bowl_share * r * r;
  if (r <= 1) return rim_m - depth_m / (1 - bowl_share) * (1 - r) * (1 - r);
  // Ejecta thin out as r^-3 (McGetchin et al. 1973). This polynomial follows that within a third of
  // the rim height, is level at the crest and ends smoothly.
  const double s = (crater_reach - r) / (crater_reach - 1);
  const double s2 = s * s;
  return rim_m * s2 * s2 * s * (6 - 5 * s);
}

std::vector<Crater> craters_touching(const CraterSurface& surface, std::uint64_t seed,
                                     const PlanePoint& low, const PlanePoint& high) {
  std::vector<Crater> craters;
  for (const Octave& octave : octaves(surface)) {
    const double reach_m = crater_reach * octave.diameter_high_m / 2;
    const double cell_m = cell_to_diameter * octave.diameter_high_m;
    const auto cell = [cell_m](double at_m) {
      return static_cast<std::int64_t>(std::floor(at_m / cell_m));
    };
    for (std::int64_t row = cell(low.y_m - reach_m); row <= cell(high.y_m + reach_m); ++row) {
      for (std::int64_t column = cell(low.x_m - reach_m); column <= cell(high.x_m + reach_m);
           ++column) {
        add_cell(surface, seed, octave, cell_m, column, row, craters);
      }
    }
  }
  std::erase_if(craters, [&](const Crater& crater) {
    const double dx = crater.centre.x_m - std::clamp(crater.centre.x_m, low.x_m, high.x_m);
    const double dy = crater.centre.y_m - std::clamp(crater.centre.y_m, low.y_m, high.y_m);
    return std::hypot(dx, dy) >= crater_reach * crater.diameter_m / 2;
  });
  return craters;
}

}  // namespace lsos
