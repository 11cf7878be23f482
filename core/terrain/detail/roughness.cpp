#include "terrain/detail/roughness.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/random.h"
#include "terrain/grid/b_spline.h"

namespace lsos {

namespace {

// Approximately normal random number: the sum of four 16-bit uniforms, with mean 0, variance 1.
double normal(std::uint64_t key, std::int64_t column, std::int64_t row) {
  // Two rounds of multiplication and shift mix a lattice point as well as needed, and are cheaper
  // than two calls of mix_key.
  std::uint64_t z = key + static_cast<std::uint64_t>(column) * 0x9e3779b97f4a7c15u +
                    static_cast<std::uint64_t>(row) * 0xd1b54a32d192ed03u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  const auto sum =
      static_cast<double>((z & 0xffff) + ((z >> 16) & 0xffff) + ((z >> 32) & 0xffff) + (z >> 48));
  constexpr double mean = 2 * 65535.0, deviation = 37837.22;  // 65536 sqrt(4/12)
  return (sum - mean) * (1 / deviation);
}

// Centred B-spline of an order, by its recurrence. The spline of order 8 (degree 7) is the
// autocorrelation of waves along one axis at a lag in lattice spacings, averaged over where in the
// lattice it is taken.
double b_spline_at(int order, double x) {  // support [-order/2, order/2]
  if (order == 1) return x >= -0.5 && x < 0.5 ? 1 : 0;
  const double half = order / 2.0;
  return ((half + x) * b_spline_at(order - 1, x + 0.5) +
          (half - x) * b_spline_at(order - 1, x - 0.5)) /
         (order - 1);
}

// Mean square difference of heights `lag` spacings apart along an axis, for waves of amplitude 1.
double structure(double lag) {
  const double at_zero = b_spline_at(8, 0);
  return 2 * at_zero * (at_zero - b_spline_at(8, lag));
}

}  // namespace

RoughnessField::RoughnessField(const Roughness& roughness, std::uint64_t seed,
                               const RoughnessGrid& grid)
    : period_(grid.period) {
  const int stretch_log2 = static_cast<int>(std::lround(std::log2(grid.height_to_width)));
  along_row_log2_ = std::max(0, stretch_log2);
  along_column_log2_ = std::max(0, -stretch_log2);
  const double spacing_m = grid.spacing_m * std::exp2(std::abs(stretch_log2) / 2.0);
  // The shortest waves are two nodes long: the grid cannot hold shorter ones. A cell's side is
  // known to some digits only: the count of octaves must not depend on the last, hence the 0.01.
  const double octaves = std::log2(roughness.longest_m / (2 * spacing_m)) + 0.01;
  int last = std::max(0, static_cast<int>(std::floor(octaves)));
  if (period_ > 0) {
    const int whole = std::countr_zero(static_cast<std::uint64_t>(period_));
    along_row_log2_ = std::min(along_row_log2_, whole);
    last = std::min(last, whole - along_row_log2_);
  }
  // Amplitudes grow in the ratio 2^hurst per octave; the lag at which the deviation is made exact
  // lies within the range of waves.
  const double lag_m = std::max(2 * spacing_m, std::min(1.0, std::ldexp(spacing_m, last)));
  double sum = 0;
  for (int k = 0; k <= last; ++k) {
    const double amplitude = std::exp2(roughness.hurst * k);
    sum += amplitude * amplitude * structure(lag_m / std::ldexp(spacing_m, k));
    octaves_.push_back(
        {mix_key(mix_key(seed, "roughness"), static_cast<std::uint64_t>(k)), k, amplitude});
  }
  const double wanted_m = roughness.deviation_m * std::pow(lag_m, roughness.hurst);
  for (Octave& octave : octaves_) octave.amplitude_m *= wanted_m / std::sqrt(sum);
}

void RoughnessField::add_to(HeightTile& tile, const NodeLattice& at) const {
  for (const Octave& octave : octaves_) {
    if (octave.k >= at.level) add_octave(octave, tile, at);
  }
}

void RoughnessField::fill_row(const Octave& octave, std::int64_t first, std::int64_t row,
                              std::vector<double>& values) const {
  const std::int64_t period = period_ >> (octave.k + along_row_log2_);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::int64_t around = first + static_cast<std::int64_t>(i);
    const std::int64_t column = period > 0 ? (around % period + period) % period : around;
    values[i] = octave.amplitude_m * normal(octave.key, column, row);
  }
}

void RoughnessField::add_octave(const Octave& octave, HeightTile& tile,
                                const NodeLattice& at) const {
  const SplineAxis columns(at.column, at.stride, octave.k + along_row_log2_);
  const SplineAxis rows(at.row, at.stride, octave.k + along_column_log2_);
  std::vector<double> values(columns.points.size());
  // Splines are summed along rows first: one line of nodes for each lattice row in use, of which
  // the last four are kept, each at the index of its number's last two bits.
  std::array<std::array<double, HeightTile::nodes>, 4> lines;
  int made = 0;
  const auto make_line = [&](std::array<double, HeightTile::nodes>& line, std::int64_t row) {
    fill_row(octave, columns.points.front(), row, values);
    for (int k = 0; k < HeightTile::nodes; ++k) {
      const double* v = &values[static_cast<std::size_t>(columns.start[k])];
      const auto& w = columns.weights[k];
      line[k] = w[0] * v[0] + w[1] * v[1] + (w[2] * v[2] + w[3] * v[3]);
    }
  };
  for (int k = 0; k < HeightTile::nodes; ++k) {
    const int start = rows.start[k];
    for (; made < start + 4; ++made) {
      make_line(lines[made & 3], rows.points[static_cast<std::size_t>(made)]);
    }
    const auto &a = lines[start & 3], &b = lines[(start + 1) & 3];
    const auto &c = lines[(start + 2) & 3], &d = lines[(start + 3) & 3];
    const auto& w = rows.weights[k];
    double* row_m = &tile.height_m(HeightTile::first_node, k + HeightTile::first_node);
    for (int i = 0; i < HeightTile::nodes; ++i) {
      row_m[i] += w[0] * a[i] + w[1] * b[i] + (w[2] * c[i] + w[3] * d[i]);
    }
  }
}

void RoughnessField::add_volumes(VolumeLattice& lattice, int level) const {
  for (const Octave& octave : octaves_) {
    if (octave.k >= level && 4 << octave.k >= lattice.spacing()) add_volumes(octave, lattice);
  }
}

// The volume of a wave's bump is its amplitude times the area between four points of its lattice.
void RoughnessField::add_volumes(const Octave& octave, VolumeLattice& lattice) const {
  const int column_log2 = octave.k + along_row_log2_, row_log2 = octave.k + along_column_log2_;
  const auto point = [](double node, int log2) {
    return static_cast<std::int64_t>(std::floor(std::ldexp(node, -log2)));
  };
  const NodeRectangle& reach = lattice.reach();
  const std::int64_t first = point(reach.U_low, column_log2);
  std::vector<double> values(
      static_cast<std::size_t>(point(reach.U_high, column_log2) - first + 1));
  const auto columns = lattice.columns(std::ldexp(static_cast<double>(first), column_log2),
                                       std::ldexp(1.0, column_log2), values.size());
  const double area = std::ldexp(1.0, column_log2 + row_log2);
  for (std::int64_t row = point(reach.V_low, row_log2); row <= point(reach.V_high, row_log2);
       ++row) {
    fill_row(octave, first, row, values);
    for (double& value : values) value *= area;
    lattice.add_row(columns, std::ldexp(static_cast<double>(row), row_log2), values);
  }
}

}  // namespace lsos
