#include "record/log_difference.h"

#include <algorithm>
#include <array>
#include <bit>

#include "record/layers.h"

namespace lsos {

namespace {

constexpr std::size_t rows_at_once = 4096;

// Compares bit by bit, as the digest does.
bool is_same(const ColumnValue& a, const ColumnValue& b) {
  const auto* x = std::get_if<double>(&a);
  const auto* y = std::get_if<double>(&b);
  if (x != nullptr && y != nullptr) {
    return std::bit_cast<std::uint64_t>(*x) == std::bit_cast<std::uint64_t>(*y);
  }
  return a == b;
}

// The values that identify the row among others: "time_s 12, rover_id SEV1".
std::string where(const LayerSpec& layer, const LogRow& row) {
  constexpr std::array names{"time_s", "rover_id", "from_id", "to_id",    "sequence", "phase",
                             "kind",   "panel",    "joint",   "resource", "key"};
  std::string text;
  for (std::size_t k = 0; k < layer.columns.size(); ++k) {
    const std::string_view name = layer.columns[k].name;
    if (std::ranges::find(names, name) == names.end()) continue;
    if (std::holds_alternative<std::monostate>(row.values[k])) continue;
    text +=
        std::string(text.empty() ? "" : ", ") + std::string(name) + " " + to_text(row.values[k]);
  }
  return text;
}

std::optional<LogDifference> difference(const LayerSpec& layer, std::int64_t number,
                                        const LogRow& a, const LogRow& b) {
  LogDifference found{std::string(layer.name), number, {}, {}, {}, where(layer, a)};
  for (std::size_t k = 0; k < layer.columns.size(); ++k) {
    if (is_same(a.values[k], b.values[k])) continue;
    found.column = layer.columns[k].name;
    found.a = a.values[k];
    found.b = b.values[k];
    return found;
  }
  if (a.geometry == b.geometry) return std::nullopt;
  found.column = "geometry";
  return found;
}

std::optional<LogDifference> first_difference(const LogReader& a, const LogReader& b,
                                              const LayerSpec& layer) {
  std::int64_t fid_a = 0, fid_b = 0, number = 0;
  // Both readers cut where rows are large at the same one, as long as the rows are equal.
  for (;;) {
    const std::vector<LogRow> rows_a = a.rows_after(layer.name, fid_a, rows_at_once);
    const std::vector<LogRow> rows_b = b.rows_after(layer.name, fid_b, rows_at_once);
    const std::size_t both = std::min(rows_a.size(), rows_b.size());
    for (std::size_t k = 0; k < both; ++k) {
      if (auto found = difference(layer, ++number, rows_a[k], rows_b[k])) return found;
    }
    if (rows_a.size() != rows_b.size()) {
      const LogRow& more = rows_a.size() > both ? rows_a[both] : rows_b[both];
      LogDifference found{std::string(layer.name), number + 1, {}, {}, {}, where(layer, more)};
      (rows_a.size() > both ? found.a : found.b) = std::string("a row");
      return found;
    }
    if (both == 0) return std::nullopt;
    fid_a = rows_a.back().fid;
    fid_b = rows_b.back().fid;
  }
}

}  // namespace

std::optional<LogDifference> first_difference(const LogReader& a, const LogReader& b) {
  for (const LayerSpec& layer : contract_layers()) {
    if (auto found = first_difference(a, b, layer)) return found;
  }
  return std::nullopt;
}

}  // namespace lsos
