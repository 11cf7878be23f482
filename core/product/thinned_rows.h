// Thins a long series so that its plot looks the same: of each stretch of rows those with the
// first, last, least and greatest value are kept.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "product/event_marks.h"

namespace lsos {

// Rows in which the rover moves and rows in which it stands form separate stretches: otherwise
// hours of standing would leave few points to a short drive.
class ThinnedRows {
 public:
  // Expected number of rows, and of those in which the rover moves.
  struct Count {
    std::size_t rows = 0, moving = 0;
  };
  // Rows are divided into `stretches`; if that leaves few in each, all are kept. Rows have
  // `columns` values; the first `deciding` of them determine which rows are kept.
  ThinnedRows(Count count, int stretches, std::size_t columns, std::size_t deciding);

  // Rows come in order of time. A value that is not modelled is NaN; a gap keeps one row in each
  // stretch. `wanted`: rows to be kept whatever their values.
  void add(double time_s, std::span<const double> values, bool is_moving = false,
           WantedRows wanted = {});
  // Closes the open stretches; to be called before rows are read.
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
    std::size_t most = 1;  // rows at most
    std::vector<Row> rows;
  };
  void close(Stretch& stretch);

  std::size_t deciding_;
  std::array<Stretch, 2> open_;  // standing, moving
  std::size_t previous_ = 0;     // index in open_ of the stretch that holds the last row
  std::vector<Row> kept_;
  std::vector<double> times_s_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace lsos
