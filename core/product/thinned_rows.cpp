#include "product/thinned_rows.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lsos {

namespace {

constexpr std::size_t few_rows = 4;

}  // namespace

ThinnedRows::ThinnedRows(std::size_t rows, int stretches, std::size_t columns, std::size_t deciding)
    : stretch_rows_(rows / static_cast<std::size_t>(stretches) + 1),
      deciding_(deciding),
      columns_(columns) {}

void ThinnedRows::add(double time_s, std::span<const double> values) {
  if (stretch_.size() == stretch_rows_) finish();
  stretch_.push_back({time_s, {values.begin(), values.end()}});
}

void ThinnedRows::finish() {
  std::set<std::size_t> kept;
  const std::size_t count = stretch_.size();
  if (count <= few_rows) {
    for (std::size_t i = 0; i < count; ++i) kept.insert(i);
  } else {
    kept = {0, count - 1};
    for (std::size_t k = 0; k < deciding_; ++k) {
      const auto value = [&](std::size_t i) { return stretch_[i].values[k]; };
      std::size_t least = count, greatest = count, gap = count;
      for (std::size_t i = 0; i < count; ++i) {
        if (std::isnan(value(i))) {
          if (gap == count) gap = i;
          continue;
        }
        if (least == count || value(i) < value(least)) least = i;
        if (greatest == count || value(i) > value(greatest)) greatest = i;
      }
      for (const std::size_t i : {least, greatest, gap}) {
        if (i < count) kept.insert(i);
      }
    }
  }
  for (const std::size_t i : kept) keep(stretch_[i]);
  stretch_.clear();
}

void ThinnedRows::keep(const Row& row) {
  times_s_.push_back(row.time_s);
  for (std::size_t k = 0; k < columns_.size(); ++k) columns_[k].push_back(row.values[k]);
}

bool ThinnedRows::has_values(std::size_t k) const {
  return std::ranges::any_of(columns_[k], [](double value) { return !std::isnan(value); });
}

}  // namespace lsos
