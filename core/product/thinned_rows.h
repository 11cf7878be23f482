// A long series with few points that looks the same: of each stretch of its rows those with the
// first, last, least and greatest value are kept.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lsos {

class ThinnedRows {
 public:
  // So many rows, as come to be added, are cut into `stretches`; where that leaves few in each, all
  // are kept. Rows have `columns` values; the first `deciding` of them say which rows are kept.
  ThinnedRows(std::size_t rows, int stretches, std::size_t columns, std::size_t deciding);

  // In order of time. A value that is not modelled is NaN; a gap keeps one row in each stretch.
  void add(double time_s, std::span<const double> values);
  // The rows of the stretch that goes on; to be called before they are read.
  void finish();

  const std::vector<double>& times_s() const { return times_s_; }
  const std::vector<double>& column(std::size_t k) const { return columns_[k]; }
  std::size_t size() const { return times_s_.size(); }
  bool has_values(std::size_t k) const;

 private:
  struct Row {
    double time_s = 0;
    std::vector<double> values;
  };
  void keep(const Row& row);

  std::size_t stretch_rows_, deciding_;
  std::vector<Row> stretch_;  // that goes on
  std::vector<double> times_s_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace lsos
