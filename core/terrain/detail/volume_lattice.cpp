#include "terrain/detail/volume_lattice.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

// Columns beside those in use, so that volumes at their edges need no test of each column.
constexpr int margin = 3;

}  // namespace

LatticePlace::LatticePlace(double at, int spacing_log2) {
  const double counted = std::ldexp(at, -spacing_log2), floor = std::floor(counted);
  first = static_cast<std::int64_t>(floor) - 1;
  weights = b_spline(counted - floor);
}

VolumeLattice::VolumeLattice(const NodeLattice& at, int column_log2, int row_log2)
    : column_log2_(column_log2),
      row_log2_(row_log2),
      columns_(at.column, at.stride, column_log2),
      rows_(at.row, at.stride, row_log2),
      heights_m_(columns_.points.size() * rows_.points.size(), 0),
      line_m_(columns_.points.size() + 2 * margin, 0) {
  const auto node = [](std::int64_t point, int log2) {
    return std::ldexp(static_cast<double>(point), log2);
  };
  reach_ = {node(columns_.points.front() - 2, column_log2),
            node(rows_.points.front() - 2, row_log2), node(columns_.points.back() + 2, column_log2),
            node(rows_.points.back() + 2, row_log2)};
}

int VolumeLattice::spacing() const { return 1 << std::min(column_log2_, row_log2_); }

void VolumeLattice::add(double U, double V, double volume_m) {
  add_to_columns({U, column_log2_}, volume_m);
  add_columns_at(V);
}

VolumeLattice::Columns VolumeLattice::columns(double U, double step, std::size_t count) const {
  Columns places;
  for (std::size_t k = 0; k < count; ++k) {
    places.emplace_back(U + static_cast<double>(k) * step, column_log2_);
  }
  return places;
}

void VolumeLattice::add_row(const Columns& at, double V, std::span<const double> volumes_m) {
  for (std::size_t k = 0; k < at.size(); ++k) add_to_columns(at[k], volumes_m[k]);
  add_columns_at(V);
}

void VolumeLattice::add_to_columns(const LatticePlace& at, double volume_m) {
  const std::int64_t first = at.first - columns_.points.front() + margin;
  if (first < 0 || first + 4 > std::ssize(line_m_)) return;
  double* line_m = &line_m_[static_cast<std::size_t>(first)];
  for (int k = 0; k < 4; ++k) line_m[k] += at.weights[k] * volume_m;
}

void VolumeLattice::add_columns_at(double V) {
  const LatticePlace at(V, row_log2_);
  const std::int64_t first = at.first - rows_.points.front();
  const double per_point = std::ldexp(1.0, -column_log2_ - row_log2_);
  for (int k = 0; k < 4; ++k) {
    if (first + k < 0 || first + k >= std::ssize(rows_.points)) continue;
    double* row_m = &heights_m_[static_cast<std::size_t>(first + k) * columns_.points.size()];
    for (std::size_t i = 0; i < columns_.points.size(); ++i) {
      row_m[i] += per_point * at.weights[k] * line_m_[i + margin];
    }
  }
  std::ranges::fill(line_m_, 0.0);
}

void VolumeLattice::subtract_from(HeightTile& tile) const {
  std::vector<std::array<double, HeightTile::nodes>> lines(rows_.points.size());
  for (std::size_t j = 0; j < lines.size(); ++j) {
    const double* row_m = &heights_m_[j * columns_.points.size()];
    for (int i = 0; i < HeightTile::nodes; ++i) {
      const double* v = row_m + columns_.start[i];
      const auto& w = columns_.weights[i];
      lines[j][i] = w[0] * v[0] + w[1] * v[1] + (w[2] * v[2] + w[3] * v[3]);
    }
  }
  for (int j = 0; j < HeightTile::nodes; ++j) {
    const auto* line = &lines[static_cast<std::size_t>(rows_.start[j])];
    const auto& w = rows_.weights[j];
    double* row_m = &tile.height_m(HeightTile::first_node, j + HeightTile::first_node);
    for (int i = 0; i < HeightTile::nodes; ++i) {
      row_m[i] -= w[0] * line[0][i] + w[1] * line[1][i] + (w[2] * line[2][i] + w[3] * line[3][i]);
    }
  }
}

}  // namespace lsos
