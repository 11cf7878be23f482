#include "product/thinned_rows.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lsos {

namespace {

constexpr std::size_t few_rows = 4;

}  // namespace

ThinnedRows::ThinnedRows(Count count, int stretches, std::size_t columns, std::size_t deciding)
    : deciding_(deciding), columns_(columns) {
  const std::size_t standing = count.rows - count.moving;
  const int kinds = standing > 0 && count.moving > 0 ? 2 : 1;
  const auto each = static_cast<std::size_t>(std::max(1, stretches / kinds));
  open_[0].most = standing / each + 1;
  open_[1].most = count.moving / each + 1;
}

void ThinnedRows::add(double time_s, std::span<const double> values, bool is_moving,
                      WantedRows wanted) {
  // If that stretch was closed since, its last row is kept anyway.
  std::vector<Row>& before = open_[previous_].rows;
  if (wanted.previous && !before.empty()) before.back().is_wanted = true;
  previous_ = is_moving ? 1 : 0;
  Stretch& stretch = open_[previous_];
  if (stretch.rows.size() == stretch.most) close(stretch);
  stretch.rows.push_back({time_s, {values.begin(), values.end()}, wanted.current});
}

void ThinnedRows::close(Stretch& stretch) {
  const std::vector<Row>& rows = stretch.rows;
  std::set<std::size_t> kept;
  const std::size_t count = rows.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (count <= few_rows || i == 0 || i == count - 1 || rows[i].is_wanted) kept.insert(i);
  }
  for (std::size_t k = 0; k < deciding_; ++k) {
    const auto value = [&](std::size_t i) { return rows[i].values[k]; };
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
  for (const std::size_t i : kept) kept_.push_back(rows[i]);
  stretch.rows.clear();
}

void ThinnedRows::finish() {
  for (Stretch& stretch : open_) close(stretch);
  std::ranges::stable_sort(kept_, {}, &Row::time_s);
  for (const Row& row : kept_) {
    times_s_.push_back(row.time_s);
    for (std::size_t k = 0; k < columns_.size(); ++k) columns_[k].push_back(row.values[k]);
  }
  kept_.clear();
}

bool ThinnedRows::has_values(std::size_t k) const {
  return std::ranges::any_of(columns_[k], [](double value) { return !std::isnan(value); });
}

}  // namespace lsos
