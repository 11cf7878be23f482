// A long series with few points that looks the same: of each stretch of its rows those with the
// first, last, least and greatest value are kept.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "product/event_marks.h"

namespace lsos {

// Rows of a rover that moves and of one that stands are stretches of their own: else hours of
// standing would leave a short drive a few points.
class ThinnedRows {
 public:
  // So many rows in all, and among them of a rover that moves, as come to be added.
  struct Count {
    std::size_t rows = 0, moving = 0;
  };
  // Rows are cut into `stretches`; where that leaves few in each, all are kept. Rows have `columns`
  // values; the first `deciding` of them say which rows are kept.
  ThinnedRows(Count count, int stretches, std::size_t columns, std::size_t deciding);

  // In order of time. A value that is not modelled is NaN; a gap keeps one row in each stretch.
  // `wanted`: rows to be kept whatever their values.
  void add(double time_s, std::span<const double> values, bool is_moving = false,
           WantedRows wanted = {});
  // The rows of the stretches that go on; to be called before they are read.
  void finish();

  const std::vector<double>& times_s() const { return times_s_; }
  const std::vector<double>& column(std::size_t k) const { return columns_[k]; }
  std::size_t size() const { return times_s_.size(); }
  bool has_values(std::size_t k) const;

 private:
  struct Row {
    double time_s = 0;
    std::vector<double> values;
    bool is_wanted = false;
  };
  struct Stretch {
    std::size_t most = 1;  // rows
    std::vector<Row> rows;
  };
  void close(Stretch& stretch);

  std::size_t deciding_;
  std::array<Stretch, 2> open_;  // standing, moving
  std::size_t previous_ = 0;     // of them, which holds the row before
  std::vector<Row> kept_;
  std::vector<double> times_s_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace lsos
