// The columns of each layer: name, type, getter and setter. One table serves creating a layer,
// writing, reading back, the digest and the products.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "planet/utc.h"
#include "record/rows.h"

namespace lsos {

// A value of type utc is a text like "2026-07-01T00:00:00.000Z".
enum class ColumnType { integer, real, text, utc };

// monostate is NULL: a NaN, an absent optional, an empty text.
using ColumnValue = std::variant<std::monostate, std::int64_t, double, std::string>;

// The latest time in a log, s after the mission's start: far beyond the longest mission.
inline constexpr double time_max_s = 1e9;

// What a column may hold. Rows are held to it when they are written (stored_value.h); and, as a log
// may come from anyone, when they are read.
struct ColumnLimits {
  double least = -1e20, greatest = 1e20;      // of numbers
  bool is_required = false;                   // never NULL
  std::span<const std::string_view> words{};  // the texts that are allowed; empty: all
  bool is_json = false;                       // a text, an object in JSON
};

// One column of the rows of type Row.
template <class Row>
struct Column {
  std::string_view name;
  ColumnType type = ColumnType::real;
  // `start` is the mission's StartTime, for columns of calendar time.
  ColumnValue (*value)(const Row& row, Instant start) = nullptr;
  // Sets the value in a row; nullptr where it follows from other columns.
  void (*set_value)(Row& row, const ColumnValue& value) = nullptr;
  ColumnLimits limits{};
};

// Layer `run`: the inputs of the run.
struct RunRow {
  std::string key;
  std::string value;
};

// The columns in the order of the file.
template <class Row>
std::span<const Column<Row>> columns();
template <>
std::span<const Column<SampleRow>> columns<SampleRow>();
template <>
std::span<const Column<JointRow>> columns<JointRow>();
template <>
std::span<const Column<PairRow>> columns<PairRow>();
template <>
std::span<const Column<SightIntervalRow>> columns<SightIntervalRow>();
template <>
std::span<const Column<PanelRow>> columns<PanelRow>();
template <>
std::span<const Column<ResourceRow>> columns<ResourceRow>();
template <>
std::span<const Column<EventRow>> columns<EventRow>();
template <>
std::span<const Column<PhaseRow>> columns<PhaseRow>();
template <>
std::span<const Column<PlannedPathRow>> columns<PlannedPathRow>();
template <>
std::span<const Column<NoteRow>> columns<NoteRow>();
template <>
std::span<const Column<RunRow>> columns<RunRow>();
template <>
std::span<const Column<OrderRow>> columns<OrderRow>();

// A value as text in the C locale, numbers in the shortest form that reads back equal; "" is NULL.
std::string to_text(const ColumnValue& value);

// The status whose name, as written by to_string, this is; absent: none.
std::optional<EventStatus> event_status(std::string_view name);

}  // namespace lsos
