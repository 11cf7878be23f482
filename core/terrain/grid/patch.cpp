#include "terrain/grid/patch.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

constexpr int term_count = 10;
constexpr int samples_a_side = 5;
constexpr int sample_count = samples_a_side * samples_a_side;
constexpr int checks_a_side = 4;

using Terms = Eigen::Matrix<double, 1, term_count>;
using Solver = Eigen::Matrix<double, term_count, sample_count>;
using Coefficients = Eigen::Matrix<double, term_count, 2>;

Terms monomials(double s, double t) {
  Terms terms;
  terms << 1, s, t, s * s, s * t, t * t, s * s * s, s * s * t, s * t * t, t * t * t;
  return terms;
}

// Samples lie at Chebyshev points; the checks lie between them and on the edge.
double sample_at(int i) { return -std::cos((i + 0.5) * 3.14159265358979323846 / samples_a_side); }
double check_at(int i) { return -1 + 2.0 * i / (checks_a_side - 1); }

// Least-squares fit to values at the samples: coefficients = solver * values.
const Solver& solver() {
  static const Solver made = [] {
    Eigen::Matrix<double, sample_count, term_count> design;
    for (int k = 0; k < sample_count; ++k) {
      design.row(k) = monomials(sample_at(k % samples_a_side), sample_at(k / samples_a_side));
    }
    return Solver(design.completeOrthogonalDecomposition().pseudoInverse());
  }();
  return made;
}

// Returns `at` moved by whole turns next to `near`.
GridCoordinates unwrapped(GridCoordinates at, const GridCoordinates& near, double period) {
  if (period > 0) at.u -= period * std::round((at.u - near.u) / period);
  return at;
}

}  // namespace

Patch::Patch(const PatchKey& key, const ExactMap& map) : Patch() {
  const double size = std::ldexp(coarsest_size_m, -key.level);
  // Sizes are exact in binary, so that every point lies in exactly one patch of a level.
  x_low_m_ = static_cast<double>(key.column) * size;
  y_low_m_ = static_cast<double>(key.row) * size;
  x_high_m_ = x_low_m_ + size;
  y_high_m_ = y_low_m_ + size;
  x_centre_m_ = x_low_m_ + size / 2;
  y_centre_m_ = y_low_m_ + size / 2;
  per_half_size_ = 2 / size;
  residual_px_ = infinite;

  const std::optional<GridCoordinates> centre = map.at({x_centre_m_, y_centre_m_});
  if (!centre) return;
  const auto from_centre = [&](double s, double t) -> std::optional<GridCoordinates> {
    const auto found = map.at({x_centre_m_ + s * size / 2, y_centre_m_ + t * size / 2});
    if (!found) return {};
    const GridCoordinates near = unwrapped(*found, *centre, map.period);
    return GridCoordinates{near.u - centre->u, near.v - centre->v};
  };

  Eigen::Matrix<double, sample_count, 2> values;
  for (int k = 0; k < sample_count; ++k) {
    const auto sample = from_centre(sample_at(k % samples_a_side), sample_at(k / samples_a_side));
    if (!sample) return;
    values.row(k) << sample->u, sample->v;
  }
  const Coefficients fitted = solver() * values;

  double residual_px = 0;
  for (int k = 0; k < checks_a_side * checks_a_side; ++k) {
    const double s = check_at(k % checks_a_side);
    const double t = check_at(k / checks_a_side);
    const auto exact = from_centre(s, t);
    if (!exact) return;
    const Eigen::Matrix<double, 1, 2> found = monomials(s, t) * fitted;
    residual_px = std::max(residual_px, std::hypot(found[0] - exact->u, found[1] - exact->v));
  }
  for (int term = 0; term < term_count; ++term) uv_[term] = fitted.row(term);
  uv_[0] += Vec2(centre->u, centre->v);
  residual_px_ = residual_px;
}

Patch Patch::scaling(double spacing_m) {
  Patch patch;
  patch.per_half_size_ = 1;
  patch.uv_[1].x() = 1 / spacing_m;
  patch.uv_[2].y() = 1 / spacing_m;
  return patch;
}

PatchKey Patch::key_of(const PlanePoint& at, int level) {
  const double per_size = static_cast<double>(1 << level) / coarsest_size_m;
  return {level, static_cast<std::int64_t>(std::floor(at.x_m * per_size)),
          static_cast<std::int64_t>(std::floor(at.y_m * per_size))};
}

GridPoint Patch::at(const PlanePoint& at) const {
  const double s = (at.x_m - x_centre_m_) * per_half_size_;
  const double t = (at.y_m - y_centre_m_) * per_half_size_;
  const double s2 = s * s;
  const double t2 = t * t;
  const auto& c = uv_;
  const Vec2 linear_s = c[1] + s * c[3] + t * c[4];  // factor of s without the cubic terms
  const Vec2 cubic_s = s2 * c[6] + (s * t) * c[7] + t2 * c[8];
  const Vec2 uv = c[0] + s * (linear_s + cubic_s) + t * (c[2] + t * c[5] + t2 * c[9]);
  const Vec2 by_s = (linear_s + s * c[3] + cubic_s + (2 * s2) * c[6] + (s * t) * c[7]);
  const Vec2 by_t =
      c[2] + (2 * t) * c[5] + (3 * t2) * c[9] + s * (c[4] + s * c[7] + (2 * t) * c[8]);
  return {uv.x(),
          uv.y(),
          by_s.x() * per_half_size_,
          by_t.x() * per_half_size_,
          by_s.y() * per_half_size_,
          by_t.y() * per_half_size_};
}

std::optional<GridPoint> exact_grid_point(const ExactMap& map, const PlanePoint& at) {
  constexpr double step_m = 0.05;
  const auto centre = map.at(at);
  if (!centre) return {};
  GridPoint point{centre->u, centre->v};
  const auto by = [&](double dx, double dy) -> std::optional<GridCoordinates> {
    const auto after = map.at({at.x_m + dx, at.y_m + dy});
    const auto before = map.at({at.x_m - dx, at.y_m - dy});
    if (!after || !before) return {};
    const GridCoordinates a = unwrapped(*after, *centre, map.period);
    const GridCoordinates b = unwrapped(*before, *centre, map.period);
    return GridCoordinates{(a.u - b.u) / (2 * step_m), (a.v - b.v) / (2 * step_m)};
  };
  const auto by_x = by(step_m, 0);
  const auto by_y = by(0, step_m);
  if (!by_x || !by_y) return {};
  point.u_by_x = by_x->u;
  point.v_by_x = by_x->v;
  point.u_by_y = by_y->u;
  point.v_by_y = by_y->v;
  return point;
}

}  // namespace lsos
